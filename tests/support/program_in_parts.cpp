#include "tests/support/program_in_parts.h"

#include <algorithm>
#include <vector>

#include "hw/isa/colour_format.h"
#include "hw/machines/regions.h"
#include "tests/support/random_program.h"

namespace csgsim::test {

namespace {

using isa::Instruction;

unsigned pick(unsigned least, unsigned most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}

bool asks(const Instruction& instruction) {
  return isa::info(instruction.opcode).clock_class == isa::ClockClass::answer;
}

/// Pixels are enabled at first and after every few instructions.
std::vector<Instruction> pick_instructions(const isa::Region& region, std::uint32_t memory_bits, std::size_t most) {
  const isa::ArrayShape shape{region.width, region.height, memory_bits};
  std::vector<Instruction> instructions(pick(1, static_cast<unsigned>(most)));
  for (std::size_t i = 0; i < instructions.size(); ++i) {
    if (i % 4 != 0) instructions[i] = *arbitrary_instruction(shape, memory_bits, 0);
    if (asks(instructions[i])) instructions[i] = {};
  }
  return instructions;
}

void pick_colour(isa::Program& program) {
  if (pick(0, 9) == 0) return;
  const unsigned width = pick(1, std::min({isa::max_field_width, program.shape.memory_bits, isa::most_colour_bits}));
  const unsigned base = pick(0, program.shape.memory_bits - width);
  program.fields.push_back(
      {"colour", {static_cast<std::uint16_t>(base), static_cast<std::uint16_t>(width)}, isa::FieldRole::colour});
  program.compile.background = pick(0, (1U << width) - 1);
}

}  // namespace

rc::Gen<isa::Program> arbitrary_program_in_parts(const machines::Machine& machine, std::size_t max_instructions) {
  return rc::gen::exec([=] {
    isa::Program program;
    program.shape = {machine.picture.width, machine.picture.height, machine.array.memory_bits};
    pick_colour(program);
    program.model.primitives = pick(0, 4);
    program.model.halfspaces = pick(0, 30);
    const unsigned skipped = std::min(pick(0, 12), 10U);  // of ten
    for (const isa::Region& region : machines::regions(machine)) {
      isa::Segment segment{.region = region, .instructions = {}};
      segment.halfspaces = pick(0, 9);
      if (pick(0, 9) >= skipped)
        segment.instructions = pick_instructions(region, program.shape.memory_bits, max_instructions);
      program.segments.push_back(segment);
    }
    return program;
  });
}

}  // namespace csgsim::test
