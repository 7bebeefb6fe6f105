// Transistor counts of pixels.
// Used by hw/process and sim/studies.
#pragma once

#include <cstdint>
#include <optional>

#include "hw/machines/machine.h"

// Silicon area of a machine's pixels. This is a model (docs/hardware.md): logic as synthesized by Yosys from the
// Verilog of hw/rtl, in transistors of static CMOS or nMOS, and memory as an assumed number of transistors per bit.
namespace csgsim::machines {

/// Circuits of the logic: static CMOS, or nMOS with depletion loads, dynamic latches and pass transistors.
enum class LogicFamily : std::uint8_t { cmos, nmos };

/// Transistors of a memory bit in a dynamic cell that can be read and written in the same clock: one for the write port
/// and two for each read port. An assumption.
constexpr std::uint32_t cell_transistors(std::uint32_t memory_reads) { return 1 + 2 * memory_reads; }

/// The fraction of the nodes of a column's tree that are followed by registers; 1 if there are registers at every
/// level.
double registered_node_fraction(const Machine& machine);

/// Transistors of the logic of one pixel of the machine: its processor and its node of the multiplier trees. In degree
/// 2 this includes the flag for roots and the adders for squares; all adders have evaluator.bits bits. Stream registers
/// are counted in proportion to registered_node_fraction(). Empty if no such pixel has been synthesized: the processors
/// are of another type, or the table has no ALU or node of that width.
std::optional<std::uint64_t> logic_transistors(const Machine& machine, LogicFamily family);

/// Transistors of one pixel with `memory_bits` bits of memory, its logic in static CMOS.
std::optional<std::uint64_t> pixel_transistors(const Machine& machine, std::uint32_t memory_bits);

}  // namespace csgsim::machines
