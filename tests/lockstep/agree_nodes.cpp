#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "hw/machines/timeline.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/regions.h"
#include "hw/multi_processor/timing.h"
#include "tests/lockstep/agree.h"
#include "tests/lockstep/divided_program.h"
#include "tests/lockstep/lockstep.h"
#include "tests/lockstep/parts.h"

namespace csgsim::test {

namespace {

/// The nodes tell of a subsegment when all are through with the last part of its list. When they are at which pixel
/// before, tests/unit/multi_processor/list_renderer_test.cpp looks at.
void check_subsegments(const isa::Program& program, const machines::Machine& machine, const TimedMachine& hardware) {
  const engine::RunResult run = engine::make_reference_engine(machine)->run(program, {});
  const machines::Timeline timeline = machines::timeline(program, machine, engine::run_outcome(run));
  std::map<std::uint32_t, std::uint64_t> ends;
  for (const TimedMachine::Told& told : hardware.told()) {
    if (!ends.contains(told.segment))
      ends[told.segment] = multi_processor::started_parts(program, machine, told.segment, run.met).back().end;
    const machines::ClockSpan& all = timeline.issued[told.segment][told.index];
    const std::uint64_t begun = timeline.cleared[told.segment].begin;
    const std::uint64_t clock = told.edge - 1;
    if (told.edge == ends[told.segment] && begun <= all.begin && all.begin <= all.end && all.end <= clock) continue;
    throw Difference(
        fmt::format("subsegment {}, instruction {}: told of in clock {}, by the timeline begun in {} and carried out "
                    "from {} to {}, all of it by {}",
                    told.segment, told.index, clock, begun, all.begin, all.end, ends[told.segment]));
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
