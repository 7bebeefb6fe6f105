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

/// The nodes report a subsegment's instructions when all nodes have finished the last part of its list. The clocks at
/// each pixel are checked by tests/unit/multi_processor/list_renderer_test.cpp.
void check_subsegments(const isa::Program& program, const machines::Machine& machine, const TimedMachine& hardware) {
  const engine::RunResult run = engine::make_reference_engine(machine)->run(program, {});
  const machines::Timeline timeline = machines::timeline(program, machine, engine::run_outcome(run));
  std::map<std::uint32_t, std::uint64_t> ends;
  for (const TimedMachine::Retirement& one : hardware.retired()) {
    if (!ends.contains(one.segment))
      ends[one.segment] = multi_processor::started_parts(program, machine, one.segment, run.pixel_activity).back().end;
    const machines::ClockSpan& all = timeline.issued[one.segment][one.index];
    const std::uint64_t begun = timeline.cleared[one.segment].begin;
    const std::uint64_t clock = one.edge - 1;
    if (one.edge == ends[one.segment] && begun <= all.begin && all.begin <= all.end && all.end <= clock) continue;
    throw Difference(fmt::format(
        "subsegment {}, instruction {}: reported in clock {}; the timeline has it cleared from {}, executed "
        "from {} to {}, and the subsegment complete by {}",
        one.segment, one.index, clock, begun, all.begin, all.end, ends[one.segment]));
  }
}

}  // namespace

bool nodes_agree(const machines::Machine& machine, const Allowed& is_allowed) {
  return parts_agree(
      "the clocked multi-processor has the predicted bits, picture, clocks, account and timeline", machine,
      [&] { return first_allowed([&] { return any_divided_program(machine); }, is_allowed); },
      [&](const isa::Program& program, const TimedMachine& hardware) {
        check_subsegments(program, machine, hardware);
      });
}

}  // namespace csgsim::test
