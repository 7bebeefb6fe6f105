// Clocks of instructions.
// Used by hw/pixel_planes, hw/pixel_square, hw/scan_line, host/effects, host/emit and sim.
#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Levels of a tree with that number of leaves: ceil(log2 leaves), 0 for one or none.
std::uint32_t tree_levels(std::uint32_t leaves);

/// Clocks from a coefficient's first bit at the roots of the multiplier trees to the first bit of F at the pixels: one
/// clock per register_levels levels of a tree, rounded up, where the trees have ceil(log2 width) and ceil(log2 height)
/// levels. This latency is added once at the end of a program, until the last instruction has reached the pixels, and
/// once per answer to the host.
std::uint32_t evaluator_latency(const Machine& machine);

/// Width in bits of the instruction's widest memory operand.
std::uint64_t widest_field_bits(const isa::Instruction& instruction);

/// Clocks of an instruction on bit-serial pixel processors below multiplier trees.
std::uint64_t bit_serial_clocks(const isa::Instruction& instruction, const Machine& machine);

/// Clocks that the machine's processors spend on an instruction; on a scan-line array, the clocks in which the words of
/// its packet enter.
std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine);

/// Total clocks of the instructions if none is skipped.
std::uint64_t clocks(std::span<const isa::Instruction> instructions, const Machine& machine);

/// Clocks of a whole run without skipped instructions, including latency. If the clocks depend on the pixels
/// (Kind::depends_on_pixels) this is an upper bound; the exact clocks are in the run's result (engine::RunResult).
std::uint64_t clocks(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
