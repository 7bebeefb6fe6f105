#include <fmt/format.h>

#include "hw/base/error.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/timing.h"
#include "hw/multi_processor/timing_model.h"
#include "hw/multi_processor/timing_parts.h"
#include "hw/multi_processor/timing_passes.h"

namespace csgsim::multi_processor {

namespace {

using machines::Machine;

constexpr double most_seconds = 1e6;
constexpr double most_clocks_told = 1e18;

void check_display_memory(Subsegments parts, const ModelSizes& sizes, std::uint64_t model_words,
                          const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const SegmentDivision division = division_of(parts);
  const std::uint64_t words =
      model_words + segment_words(sizes, division.primitives, division.halfspaces, figures.word_bits);
  if (words <= figures.display_memory_words) return;
  throw InputError(
      fmt::format("the model and what the segment at {},{} leaves of it are {} words, and the display processor of {} "
                  "has {}; take a machine file with more display.memory_words, or give the model fewer faces",
                  parts.front().region.x, parts.front().region.y, words, machine.name, figures.display_memory_words));
}

double test_clocks(const isa::Segment& part, const Figures& figures) {
  const isa::DivisionCounts& counts = part.division;
  const isa::DivisionStep own = counts.sum();
  const auto clocks = [](std::uint64_t count, std::uint32_t each) { return static_cast<double>(count) * each; };
  return clocks(counts.group_boxes, figures.display_tests.primitive) +
         clocks(counts.group_halfspaces, figures.display_tests.halfspace) +
         clocks(counts.group_cells, figures.display_tests.cell) + clocks(own.boxes, figures.node_tests.primitive) +
         clocks(own.halfspaces, figures.node_tests.halfspace) + clocks(own.cells, figures.node_tests.cell) +
         clocks(own.nodes, figures.node_tests.tree_node) +
         clocks(part.instructions.size(), figures.node_tests.instruction);
}

/// In words of a bit: of which no width of the bus takes more.
double data_words(const isa::Segment& part, const ModelSizes& sizes) {
  const isa::DivisionCounts& counts = part.division;
  const auto words = [&](std::uint64_t primitives, std::uint64_t halfspaces) {
    return static_cast<double>(segment_words(sizes, primitives, halfspaces, 1));
  };
  return words(1, 1) * (1 + static_cast<double>(counts.sum().boxes) + static_cast<double>(counts.group_entries));
}

void check_time(const isa::Program& program, const ModelSizes& sizes, const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  double clocks = static_cast<double>(figures.host.latency) + machine.link.latency +
                  static_cast<double>(host_words(program, figures.host.width)) * figures.host.word_clocks +
                  static_cast<double>(sizes.planes) * figures.transform_clocks +
                  static_cast<double>(frame_words(sizes, machine.link.width)) * machine.link.word_clocks;
  for (const isa::Segment& part : program.segments) {
    const double words = static_cast<double>(list_words(part, machine.link.width)) + 100 + data_words(part, sizes);
    clocks += test_clocks(part, figures) + words * machine.link.word_clocks + 2.0 * machine.link.latency +
              3.0 * figures.barrier_clocks;
    // A message for each command at most, and a word more.
    const double messages = static_cast<double>(part.instructions.size()) + 3;
    clocks += 2.0 * messages * (machine.link.latency + machine.link.word_clocks + figures.barrier_clocks);
    clocks += most_rendering_clocks(part.instructions, part.region, machine);
  }
  if (clocks <= most_clocks_told && clocks <= most_seconds * static_cast<double>(machine.clock_hz)) return;
  throw InputError(
      fmt::format("a frame may take {:.3g} clocks of {}, which is longer than is simulated; give it a smaller model or "
                  "picture, or faster figures",
                  clocks, machine.name));
}

}  // namespace

void check_fits(const isa::Program& program, const Machine& machine) {
  const ModelSizes sizes = sizes_of(program.display_model);
  if (sizes.planes == 0 && sizes.depth == 0) {
    throw InputError(fmt::format(
        "the Program has no display model, which {} divides; compile the model for this machine", machine.name));
  }
  check_time(program, sizes, machine);
  const std::uint64_t model_words = host_words(program, machines::own<Figures>(machine).word_bits);
  for (const Subsegments parts : by_segment(program, machine)) {
    list_room(parts, sizes, machine);
    check_display_memory(parts, sizes, model_words, machine);
  }
}

}  // namespace csgsim::multi_processor
