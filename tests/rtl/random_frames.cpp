#include "tests/rtl/random_frames.h"

#include <algorithm>
#include <cstdint>

#include "hw/isa/opcode.h"
#include "hw/machines/regions.h"
#include "tests/support/random_program.h"

namespace csgsim::rtl {

namespace {

/// Any number of `least` to `most`, whatever the size that rapidcheck has come to.
std::uint32_t pick(std::uint32_t least, std::uint32_t most) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(least, most + 1));
}

void erase_questions(isa::Program& program) {
  for (isa::Segment& segment : program.segments)
    std::erase_if(segment.instructions,
                  [](const isa::Instruction& instruction) { return isa::is_question(instruction.opcode); });
}

}  // namespace

rc::Gen<std::vector<isa::Program>> arbitrary_frames(const machines::Machine& machine, std::size_t instructions) {
  return rc::gen::exec([=] {
    const std::uint32_t widest = std::min(isa::max_field_width, machine.array.memory_bits / 2);
    const bool coloured = pick(0, 3) > 0;
    const std::uint32_t width = coloured ? pick(1, widest) : 0;
    isa::ArrayShape shape = machine.array;
    shape.memory_bits -= machines::second_buffer(width, machine).width;
    std::vector<isa::Program> frames(pick(1, 3));
    for (isa::Program& frame : frames) {
      frame = *test::arbitrary_program(shape, instructions / frames.size(), machine.evaluator_degree);
      if (!machines::has_global_or(machine)) erase_questions(frame);
      frame.facts.fields.clear();
      frame.colour = {static_cast<std::uint16_t>(pick(0, shape.memory_bits - width)),
                      static_cast<std::uint16_t>(width)};
    }
    return frames;
  });
}

}  // namespace csgsim::rtl
