#include "tests/rtl/random_frames.h"

#include <algorithm>
#include <cstdint>

#include "hw/isa/facts.h"
#include "hw/machines/regions.h"
#include "tests/rtl/commands.h"
#include "tests/support/random_program.h"

namespace csgsim::rtl {

rc::Gen<std::vector<isa::Program>> arbitrary_frames(const machines::Machine& machine, std::size_t instructions) {
  return rc::gen::exec([=] {
    const std::uint32_t widest = std::min(isa::max_field_width, machine.array.memory_bits / 2);
    const bool coloured = random_between(0, 3) > 0;
    const std::uint32_t width = coloured ? random_between(1, widest) : 0;
    isa::ArrayShape shape = machine.array;
    shape.memory_bits -= machines::second_buffer(width, machine).width;
    std::vector<isa::Program> frames(random_between(1, 3));
    for (isa::Program& frame : frames) {
      frame = *test::arbitrary_program(shape, instructions / frames.size(), machine.evaluator_degree);
      if (!machines::has_global_or(machine))
        for (isa::Segment& segment : frame.segments) test::erase_queries(segment.instructions);
      frame.facts->fields.clear();
      frame.colour = {static_cast<std::uint16_t>(random_between(0, shape.memory_bits - width)),
                      static_cast<std::uint16_t>(width)};
    }
    return frames;
  });
}

}  // namespace csgsim::rtl
