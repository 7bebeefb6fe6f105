#include "hw/machines/clocks.h"

#include <algorithm>
#include <bit>

#include "hw/machines/timing.h"

namespace csgsim::machines {

namespace {

std::uint32_t tree_levels(std::uint32_t leaves) {
  return leaves <= 1 ? 0 : static_cast<std::uint32_t>(std::bit_width(leaves - 1));
}

/// Width of the widest memory operand.
std::uint64_t field_width(const isa::Instruction& instruction) {
  std::uint64_t width = 0;
  for (const isa::Field& field : instruction.fields) width = std::max<std::uint64_t>(width, field.width);
  return width;
}

/// Clocks in which every bit of the widest memory operand has passed the ALU.
std::uint64_t field_clocks(const isa::Instruction& instruction, const Machine& machine) {
  return (field_width(instruction) + machine.alu_bits - 1) / machine.alu_bits;
}

}  // namespace

std::uint32_t evaluator_latency(const isa::ArrayShape& array) {
  return tree_levels(array.width) + tree_levels(array.height);
}

std::uint64_t packet_words(const isa::Instruction& instruction, const Machine& machine) {
  const std::uint64_t word = std::max(machine.scan_line.word_bits, 1U);
  const std::uint64_t bits = std::max<std::uint64_t>({instruction.linear.width, field_width(instruction), 1});
  return (bits + word - 1) / word;
}

std::uint64_t clocks(const isa::Instruction& instruction, const Machine& machine) {
  if (machine.kind == Kind::scan_line) {
    return packet_words(instruction, machine) * machine.scan_line.packet_interval;
  }
  switch (isa::info(instruction.opcode).clock_class) {
    case isa::ClockClass::one: return 1;
    case isa::ClockClass::linear_once: return instruction.linear.width;
    case isa::ClockClass::linear_twice: return 2ULL * instruction.linear.width;
    case isa::ClockClass::field: return field_clocks(instruction, machine);
    case isa::ClockClass::two_fields: return field_clocks(instruction, machine) * (machine.memory_reads >= 2 ? 1 : 2);
    case isa::ClockClass::answer: return 1ULL + evaluator_latency(machine.array);
  }
  return 0;
}

std::uint64_t clocks(std::span<const isa::Instruction> instructions, const Machine& machine) {
  std::uint64_t total = 0;
  for (const isa::Instruction& instruction : instructions) total += clocks(instruction, machine);
  return total;
}

std::uint64_t clocks(const isa::Program& program, const Machine& machine) {
  return time_frame(program, machine).clocks;
}

FrameTiming time_frame(const isa::Program& program, const Machine& machine) {
  switch (machine.kind) {
    case Kind::frame_buffer: return time_whole(program, machine);
    case Kind::scan_line: return time_lines(program, machine);
    case Kind::pixel_square: return time_squares(program, machine);
  }
  return {};
}

FrameTiming time_whole(const isa::Program& program, const Machine& machine) {
  std::uint64_t total = evaluator_latency(machine.array);
  for (const isa::Segment& segment : program.segments) total += clocks(segment.instructions, machine);
  return {total, {}};
}

}  // namespace csgsim::machines
