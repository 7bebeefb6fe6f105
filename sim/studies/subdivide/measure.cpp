#include "sim/studies/subdivide/measure.h"

#include <algorithm>

#include "host/emit/compile.h"
#include "hw/isa/host_counts.h"
#include "hw/machines/clocks.h"
#include "hw/machines/kind.h"
#include "hw/machines/timing.h"
#include "sim/functional/clocks.h"

namespace csgsim::studies {

namespace {

isa::Program compiled(const Subdivided& subdivided, const machines::Machine& machine) {
  return emit::compile(subdivided.tree, subdivided.scene, subdivided.view, machine, subdivided.options);
}

/// Sums up the segments of the Program, which may stand for segments or subsegments.
Squares tally(const isa::Program& program, const machines::Machine& machine) {
  Squares squares;
  std::uint64_t clocks = 0;
  squares.count = program.segments.size();
  for (const isa::Segment& segment : program.segments) {
    if (segment.facts->primitives > 0) ++squares.touched;
    squares.primitives += segment.facts->primitives;
    squares.halfspaces += segment.facts->halfspaces;
    squares.kept_primitives += segment.facts->kept_primitives;
    squares.kept_halfspaces += segment.facts->kept_halfspaces;
    squares.comparisons += segment.facts->comparisons;
    clocks += machines::clocks(segment.instructions, machine);
  }
  const auto touched = static_cast<double>(std::max<std::uint64_t>(squares.touched, 1));
  for (double* sum : {&squares.primitives, &squares.halfspaces, &squares.kept_primitives, &squares.kept_halfspaces,
                      &squares.comparisons}) {
    *sum /= touched;
  }
  squares.instruction_clocks = clocks;
  return squares;
}

/// Clocks at pixels by purpose.
struct PixelClocks {
  double render = 0;
  double classify = 0;
  double merge = 0;
  double all = 0;
};

PixelClocks pixel_clocks(const isa::Program& program, const machines::Machine& machine,
                         const machines::RunOutcome& outcome) {
  PixelClocks sums;
  for (std::size_t s = 0; s < program.segments.size(); ++s) {
    const isa::Segment& segment = program.segments[s];
    for (std::size_t i = 0; i < segment.instructions.size(); ++i) {
      const isa::Instruction& instruction = segment.instructions[i];
      const auto clocks = static_cast<double>(
          machine.kind
              ->clocks_at_pixels(segment, i, machine,
                                 outcome.pixel_activity.empty() ? nullptr : &outcome.pixel_activity[s])
              .all);
      sums.all += clocks;
      switch (instruction.origin.purpose) {
        case isa::Purpose::render: sums.render += clocks; break;
        case isa::Purpose::classify:
        case isa::Purpose::stack: sums.classify += clocks; break;
        case isa::Purpose::merge: sums.merge += clocks; break;
        case isa::Purpose::setup:
        case isa::Purpose::shade:
        case isa::Purpose::effect: break;
      }
    }
  }
  sums.all = std::max(sums.all, 1.0);
  return sums;
}

bool reports_stages(const machines::Account& account) {
  return std::ranges::find(account.counts, "transformation_clocks", &machines::Count::name) != account.counts.end();
}

Stages stages_of(const machines::FrameTiming& timing, const PixelClocks& pixels, const machines::Machine& machine) {
  const auto seconds = [&](std::uint64_t clocks) {
    return static_cast<double>(clocks) / static_cast<double>(machine.clock_hz);
  };
  const auto count = [&](const char* name) { return timing.account.count(name); };
  const auto stage = [&](const char* name) { return seconds(count(name)); };
  Stages stages;
  stages.halfspace_tests = count("first_halfspace_tests");
  const std::uint64_t drawn = std::max<std::uint64_t>(count("active_segments"), 1);
  stages.broadcast_halfspaces = static_cast<double>(count("broadcast_halfspaces")) / static_cast<double>(drawn);
  stages.transformation = stage("transformation_clocks");
  stages.first_pruning = stage("first_pruning_clocks");
  stages.second_pruning = stage("second_pruning_clocks");
  stages.communication = stage("reception_clocks") + stage("broadcasting_clocks") + stage("sharing_clocks");
  const double rendering = stage("rendering_clocks");
  stages.rendering = rendering;
  stages.scan_conversion = rendering * pixels.render / pixels.all;
  stages.classification = rendering * pixels.classify / pixels.all;
  stages.depth_sort = rendering * pixels.merge / pixels.all;
  stages.total = seconds(timing.clocks);
  return stages;
}

}  // namespace

SubdivideRow measure_squares(const Subdivided& subdivided, unsigned levels) {
  const auto cut_into = [&](machines::Parts parts) {
    return subdivided.machine.kind->subdivided(subdivided.machine, levels, parts).value();
  };
  const machines::Machine whole = cut_into(machines::Parts::segments);
  const machines::Machine cut = cut_into(machines::Parts::subsegments);
  const isa::Program in_segments = compiled(subdivided, whole);
  const isa::Program in_subsegments = compiled(subdivided, cut);
  const machines::RunRecord record = functional::make_run_record(in_subsegments, cut);
  const machines::FrameTiming timing = machines::time_frame(in_subsegments, cut, record.outcome());
  SubdivideRow row;
  row.segments = tally(in_segments, whole);
  row.subsegments = tally(in_subsegments, cut);
  row.subsegments.clocks = timing.clocks;
  if (!reports_stages(timing.account)) {
    row.segments.clocks = machines::clocks(in_segments, whole);
    return row;
  }
  row.segments.instruction_clocks.reset();
  row.subsegments.instruction_clocks.reset();
  row.stages = stages_of(timing, pixel_clocks(in_subsegments, cut, record.outcome()), cut);
  row.stages.halfspaces_touching = 0;
  for (const isa::Segment& segment : in_segments.segments) *row.stages.halfspaces_touching += segment.facts->halfspaces;
  return row;
}

}  // namespace csgsim::studies
