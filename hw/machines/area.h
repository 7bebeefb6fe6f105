#pragma once

#include <cstdint>
#include <optional>

#include "hw/machines/machine.h"

/// What the pixels of a machine take in silicon. A model (docs/area.md): logic as Yosys synthesises the Verilog of
/// hw/rtl, in transistors of static CMOS, and memory as a number of transistors a bit, which is assumed.
namespace csgsim::machines {

/// Of a memory bit in a dynamic cell that can be read and written in the same clock: one to write, and two for each
/// port that reads. Assumed.
constexpr std::uint32_t cell_transistors(std::uint32_t memory_reads) { return 1 + 2 * memory_reads; }

/// The part of the nodes of a column's tree behind which there are registers: all with registers behind every level.
double registered_nodes(const Machine& machine);

/// Of one pixel of the machine, if it had so many memory bits: processor, memory and its node of the multiplier trees,
/// where its expressions are of degree 2 with the flag for roots and the adders for squares, and all adders as wide as
/// evaluator.bits. Of its streams' registers as much is counted as its share of those that there are.
/// None where that pixel has not been synthesised: the machine's processors are of another make, or its ALU or its node
/// is of another width.
std::optional<std::uint64_t> pixel_transistors(const Machine& machine, std::uint32_t memory_bits);

}  // namespace csgsim::machines
