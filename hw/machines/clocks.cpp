#include "hw/machines/clocks.h"

#include <algorithm>
#include <bit>

#include "hw/base/quotient.h"
#include "hw/isa/opcodes.h"

namespace csgsim::machines {

namespace {

/// Clocks until every bit of the widest memory operand has passed the ALU.
std::uint64_t field_clocks(const isa::Instruction& instruction, const Machine& machine) {
  return quotient_up(widest_field_bits(instruction), machine.alu_bits);
}

/// Clocks until every bit of the expression has reached the pixels once.
std::uint64_t linear_clocks(const isa::Instruction& instruction, const Machine& machine) {
  return quotient_up(std::uint64_t{instruction.linear.width}, std::uint64_t{machine.evaluator_bits});
}

/// Bit k of the root takes 3 clocks, plus one clock for each of the k bits before it (two if root and remainder share
/// one read port).
std::uint64_t root_clocks(std::uint64_t bits, const Machine& machine) {
  return machine.memory_reads >= 2 ? (bits * bits + 5 * bits) / 2 : bits * bits + 2 * bits;
}

}  // namespace

std::uint32_t tree_levels(std::uint32_t leaves) {
  return leaves <= 1 ? 0 : static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

std::uint32_t evaluator_latency(const Machine& machine) {
  return quotient_up(tree_levels(machine.array.width), machine.register_levels) +
         quotient_up(tree_levels(machine.array.height), machine.register_levels);
}

std::uint64_t widest_field_bits(const isa::Instruction& instruction) {
  std::uint64_t width = 0;
  for (const isa::Field& field : instruction.fields) width = std::max<std::uint64_t>(width, field.width);
  return width;
}

std::uint64_t bit_serial_clocks(const isa::Instruction& instruction, const Machine& machine) {
  switch (isa::info(instruction.opcode).clock_class) {
    case isa::ClockClass::one: return 1;
    case isa::ClockClass::linear_once: return linear_clocks(instruction, machine);
    case isa::ClockClass::linear_twice: return 2 * linear_clocks(instruction, machine);
    case isa::ClockClass::field: return field_clocks(instruction, machine);
    case isa::ClockClass::two_fields: return field_clocks(instruction, machine) * (machine.memory_reads >= 2 ? 1 : 2);
    case isa::ClockClass::root: return root_clocks(instruction.fields[0].width / 2, machine);
    case isa::ClockClass::answer: return 1ULL + evaluator_latency(machine);
  }
  return 0;
}

}  // namespace csgsim::machines
