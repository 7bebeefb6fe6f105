#include "sim/studies/subdivide/measure.h"

#include <algorithm>

#include "host/emit/compile.h"
#include "hw/machines/clocks.h"
#include "hw/machines/timing.h"
#include "hw/multi_processor/figures.h"

namespace csgsim::studies {

namespace {

isa::Program compiled(const Subdivided& subdivided, const machines::Machine& machine) {
  return emit::compile(subdivided.tree, subdivided.scene, subdivided.view, machine, subdivided.options);
}

/// Its parts, whatever they are of.
Squares tally(const isa::Program& program, const machines::Machine& machine) {
  Squares squares;
  squares.count = program.segments.size();
  for (const isa::Segment& segment : program.segments) {
    if (segment.facts.primitives > 0) ++squares.touched;
    squares.primitives += segment.facts.primitives;
    squares.halfspaces += segment.facts.halfspaces;
    squares.kept_primitives += segment.facts.kept_primitives;
    squares.kept_halfspaces += segment.facts.kept_halfspaces;
    squares.comparisons += segment.facts.comparisons;
    squares.instruction_clocks += machines::clocks(segment.instructions, machine);
  }
  const auto touched = static_cast<double>(std::max<std::uint64_t>(squares.touched, 1));
  for (double* sum : {&squares.primitives, &squares.halfspaces, &squares.kept_primitives, &squares.kept_halfspaces,
                      &squares.comparisons}) {
    *sum /= touched;
  }
  return squares;
}

/// Clocks at pixels, by what they are for.
struct PixelClocks {
  double render = 0;
  double classify = 0;
  double merge = 0;
  double all = 0;
};

PixelClocks pixel_clocks(const isa::Program& program, const machines::Machine& machine) {
  PixelClocks sums;
  for (const isa::Segment& segment : program.segments) {
    const double pixels = static_cast<double>(segment.region.width) * segment.region.height;
    for (const isa::Instruction& instruction : segment.instructions) {
      const double clocks = pixels * static_cast<double>(machines::clocks(instruction, machine));
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

StageSeconds seconds_of(const machines::FrameTiming& timing, const PixelClocks& pixels,
                        const machines::Machine& machine) {
  const auto seconds = [&](std::uint64_t clocks) {
    return static_cast<double>(clocks) / static_cast<double>(machine.clock_hz);
  };
  const auto stage = [&](const char* name) { return seconds(timing.account.count(name)); };
  StageSeconds stages{
      .transformation = stage("transformation_clocks"),
      .first_pruning = stage("first_pruning_clocks"),
      .second_pruning = stage("second_pruning_clocks"),
      .communication = stage("reception_clocks") + stage("broadcasting_clocks") + stage("sharing_clocks"),
      .rendering = stage("rendering_clocks"),
      .total = seconds(timing.clocks)};
  stages.scan_conversion = stages.rendering * pixels.render / pixels.all;
  stages.classification = stages.rendering * pixels.classify / pixels.all;
  stages.depth_sort = stages.rendering * pixels.merge / pixels.all;
  return stages;
}

}  // namespace

Squares measure_squares(const Subdivided& subdivided, const machines::Size& square) {
  machines::Machine machine = subdivided.machine;
  machine.array.width = square.width;
  machine.array.height = square.height;
  const isa::Program program = compiled(subdivided, machine);
  Squares squares = tally(program, machine);
  squares.clocks = machines::clocks(program, machine);
  return squares;
}

Stages measure_stages(const Subdivided& subdivided, unsigned levels) {
  machines::Machine machine = subdivided.machine;
  machines::own<multi_processor::Figures>(machine).levels = levels;
  machines::Machine undivided = machine;  // its one node draws a segment as a whole
  undivided.array.width = 1;
  undivided.array.height = 1;
  const isa::Program in_segments = compiled(subdivided, undivided);
  const isa::Program program = compiled(subdivided, machine);
  const machines::FrameTiming timing = machines::time_frame(program, machine);
  Stages stages{.segments = tally(in_segments, undivided),
                .subsegments = tally(program, machine),
                .seconds = seconds_of(timing, pixel_clocks(program, machine), machine),
                .halfspace_tests = timing.account.count("first_halfspace_tests")};
  for (const isa::Segment& segment : in_segments.segments) stages.halfspaces_touching += segment.facts.halfspaces;
  const std::uint64_t drawn = std::max<std::uint64_t>(timing.account.count("active_segments"), 1);
  stages.broadcast_halfspaces =
      static_cast<double>(timing.account.count("broadcast_halfspaces")) / static_cast<double>(drawn);
  stages.subsegments.clocks = timing.clocks;
  return stages;
}

}  // namespace csgsim::studies
