#pragma once

#include <cstdint>
#include <span>

#include "hw/isa/instruction.h"
#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Clocks between a coefficient's first bit at the roots of the multiplier trees and the first bit of F at the pixels:
/// one a tree level, ceil(log2 width) + ceil(log2 height). A program pays it once at its end (the last instruction has
/// to reach the pixels) and once at each answer to the host.
std::uint32_t evaluator_latency(const isa::ArrayShape& array);

/// Words of a scan-line array's packet: as many as the instruction's widest operand has, one at least.
std::uint64_t packet_words(const isa::Instruction& instruction, const Machine& machine);

/// Clocks that the controller spends on an instruction, without the program's final latency. A scan-line array's:
/// those in which its packet's words enter.
std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine);

/// Clocks that the controller spends on these, if none is skipped.
std::uint64_t clocks(std::span<const isa::Instruction> instructions, const Machine& machine);

/// Clocks of a whole run in which no instruction is skipped, latency included: no run takes more. What a run really
/// takes, only the run tells (sim::RunResult).
std::uint64_t clocks(const isa::Program& program, const Machine& machine);

}  // namespace csgsim::machines
