#include <fmt/format.h>

#include <algorithm>

#include "hw/base/error.h"
#include "hw/isa/host_counts.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/refresh.h"
#include "hw/multi_processor/timing.h"
#include "hw/multi_processor/timing_model.h"
#include "hw/multi_processor/timing_parts.h"
#include "hw/multi_processor/timing_passes.h"

namespace csgsim::multi_processor {

namespace {

using machines::Machine;

constexpr double max_seconds = 1e6;
constexpr double max_reported_clocks = 1e18;

void check_display_memory(const DisplayMemory& memory, const Machine& machine) {
  const std::uint64_t available = machines::kind_figures<Figures>(machine).display_memory_words;
  if (memory.model_words <= available) return;
  throw InputError(
      fmt::format("the model without its planes needs {} words, but the display processor of {} has {}; increase "
                  "display.memory_words in the machine file, or use a model with fewer faces",
                  memory.model_words, machine.name, available));
}

/// What remains of the model in a segment must fit the memory of all nodes or of the display processor.
void check_segment_memory(Subsegments parts, const ModelSizes& sizes, const DisplayMemory& memory,
                          const Machine& machine) {
  const bool is_remote = list_room(parts, sizes, machine).is_remote;
  if (!is_remote || memory.can_hold(segment_division(parts), sizes, machines::kind_figures<Figures>(machine))) return;
  throw InputError(fmt::format(
      "what remains of the model in the segment at {},{} fits neither the memory of the nodes of {} nor that of its "
      "display processor; increase node.memory_words, display.memory_words or subdivision.levels in the machine file",
      parts.front().region.x, parts.front().region.y, machine.name));
}

/// Upper bound: half-spaces are read over the bus, planes from the host, and the first pruning is done twice.
double test_clocks(const isa::Segment& part, const ModelSizes& sizes, const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  const auto plane = static_cast<double>(remote_plane_clocks(sizes, figures));
  const TestClocks each = node_test_clocks(sizes, figures);
  const auto read = static_cast<double>(read_clocks(sizes, machine).clocks());
  const isa::DivisionCounts& counts = *part.division;
  const isa::DivisionStep own = counts.sum();
  const auto clocks = [](std::uint64_t count, std::uint32_t price) { return static_cast<double>(count) * price; };
  const double first = clocks(counts.group_boxes, figures.display_tests.primitive) +
                       clocks(counts.group_halfspaces, figures.display_tests.halfspace) +
                       clocks(counts.group_cells, figures.display_tests.cell);
  return 2 * (first + plane * static_cast<double>(counts.group_halfspaces)) +
         read * static_cast<double>(own.halfspaces) + clocks(own.boxes, each.primitive) +
         clocks(own.halfspaces, each.halfspace) + clocks(own.cells, each.cell) + clocks(own.nodes, each.tree_node) +
         clocks(part.instructions.size(), std::max(each.instruction, figures.number_clocks));
}

/// Upper bound, in one-bit words: no bus width needs more words.
double data_words(const isa::Segment& part, const ModelSizes& sizes) {
  const isa::DivisionCounts& counts = *part.division;
  const auto words = [&](std::uint64_t primitives, std::uint64_t halfspaces) {
    return static_cast<double>(segment_words(sizes, primitives, halfspaces, 1));
  };
  return words(1, 1) * (1 + static_cast<double>(counts.sum().boxes) + static_cast<double>(counts.group_entries));
}

void check_time(const isa::Program& program, const ModelSizes& sizes, const Machine& machine) {
  const Figures& figures = machines::kind_figures<Figures>(machine);
  double clocks = static_cast<double>(figures.host.latency) + machine.link.latency +
                  static_cast<double>(host_words(program, figures.host.width)) * figures.host.word_clocks +
                  static_cast<double>(sizes.planes) * figures.transform_clocks +
                  static_cast<double>(frame_words(sizes, machine.link.width)) * machine.link.word_clocks;
  for (const isa::Segment& part : program.segments) {
    // An instruction may have one bit more than on a link.
    const double words = static_cast<double>(list_words(part, machine.link.width) + part.instructions.size()) + 100 +
                         data_words(part, sizes);
    clocks += test_clocks(part, sizes, machine) + words * machine.link.word_clocks + 2.0 * machine.link.latency +
              3.0 * figures.barrier_clocks;
    // Upper bound: one message per command, and one more word each.
    const double messages = static_cast<double>(part.instructions.size()) + 3;
    clocks += 2.0 * messages * (machine.link.latency + machine.link.word_clocks + figures.barrier_clocks);
    clocks += max_rendering_clocks(part.instructions, part.region, longest_form(sizes, machine), machine);
  }
  // Upper bound of the slowdown by the screen's turns.
  const Refresh refresh(isa::frame_header(program), machine);
  const double taken = static_cast<double>(refresh.turns_per_second()) * figures.refresh.clocks;
  clocks *= static_cast<double>(machine.clock_hz) / (static_cast<double>(machine.clock_hz) - taken);
  if (clocks <= max_reported_clocks && clocks <= max_seconds * static_cast<double>(machine.clock_hz)) return;
  throw InputError(
      fmt::format("a frame may take {:.3g} clocks on {}, more than the simulator supports; use a smaller model or "
                  "picture, or a faster machine",
                  clocks, machine.name));
}

}  // namespace

void check_fits(const isa::Program& program, const Machine& machine) {
  const ModelSizes sizes = read_model_sizes(program.display_model);
  if (sizes.planes == 0 && sizes.depth == 0) {
    throw InputError(fmt::format(
        "the Program has no display model for {} to divide; compile the model for this machine", machine.name));
  }
  check_refresh(isa::frame_header(program), machine);
  check_time(program, sizes, machine);
  const DisplayMemory memory = display_memory(program, sizes, machines::kind_figures<Figures>(machine));
  check_display_memory(memory, machine);
  for (const Subsegments parts : subsegments_by_segment(program, machine))
    check_segment_memory(parts, sizes, memory, machine);
}

}  // namespace csgsim::multi_processor
