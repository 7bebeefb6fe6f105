#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Levels of a tree with so many leaves: ceil(log2 leaves), 0 for one or none.
std::uint32_t tree_levels(std::uint32_t leaves);

/// Clocks between a coefficient's first bit at the roots of the multiplier trees and the first bit of F at the pixels:
/// one for as many levels of a tree as lie between registers, of ceil(log2 width) in one and ceil(log2 height) in the
/// other. A program pays it once at its end (the last instruction has
/// to reach the pixels) and once at each answer to the host.
std::uint32_t evaluator_latency(const Machine& machine);

/// Width of the widest memory operand.
std::uint64_t field_width(const isa::Instruction& instruction);

/// Clocks of an instruction on bit-serial pixel processors below multiplier trees.
std::uint64_t bit_serial_clocks(const isa::Instruction& instruction, const Machine& machine);

/// Clocks that the machine's processors spend on an instruction; of a scan-line array, those in which its packet's
/// words enter.
std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine);

/// Clocks that they spend on these, if none is skipped.
std::uint64_t clocks(std::span<const isa::Instruction> instructions, const Machine& machine);

/// Clocks of a whole run in which no instruction is skipped, latency included; of a kind that asks for pixels
/// (Kind::asks_for_pixels) a bound. What a run really takes, only the run tells (engine::RunResult).
std::uint64_t clocks(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
