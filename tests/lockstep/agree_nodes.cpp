#include <fmt/format.h>

#include <algorithm>

#include "hw/machines/timeline.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/regions.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/divided_program.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/parts.h"

namespace csgsim::test {

namespace {

/// The nodes tell of a subsegment when all are through with it: as long after its first clock as the slowest takes.
/// When they are at which pixel before, tests/unit/multi_processor/list_renderer_test.cpp looks at.
void check_subsegments(const isa::Program& program, const machines::Machine& machine, const TimedMachine& hardware) {
  const machines::Timeline timeline = machines::timeline(program, machine);
  const isa::Field colour = program.colour;
  for (const TimedMachine::Told& told : hardware.told()) {
    const isa::Segment& part = program.segments[told.segment];
    std::uint64_t slowest = 0;
    for (std::uint32_t node = 0; node < machine.array.width * machine.array.height; ++node) {
      const auto own = multi_processor::pixels_of(part.region, machine.array, node / machine.array.width,
                                                  node % machine.array.width);
      slowest = std::max(slowest, multi_processor::rendering_clocks(part.instructions, own, colour, machine));
    }
    const machines::ClockSpan& all = timeline.issued[told.segment][told.index];
    const std::uint64_t begun = timeline.cleared[told.segment].begin;
    const std::uint64_t clock = told.edge - 1;
    if (clock == begun + slowest && begun <= all.begin && all.begin <= all.end && all.end <= clock) continue;
    throw Difference(
        fmt::format("subsegment {}, instruction {}: told of in clock {}, by the timeline begun in {} and "
                    "carried out from {} to {}, the slowest node takes {}",
                    told.segment, told.index, clock, begun, all.begin, all.end, slowest));
  }
}

}  // namespace

bool agree_nodes(const machines::Machine& machine, const Allowed& allowed) {
  return agree_in_parts(
      "the clocked multi-processor leaves the bits, picture, clocks, account and timeline worked out", machine,
      [&] { return first_allowed([&] { return any_divided_program(machine); }, allowed); },
      [&](const isa::Program& program, const TimedMachine& hardware) {
        check_subsegments(program, machine, hardware);
      });
}

}  // namespace csgsim::test
