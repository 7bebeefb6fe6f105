#include "hw/multi_processor/timing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "hw/base/error.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/regions.h"

namespace csgsim::multi_processor {

namespace {

using machines::FrameTiming;
using machines::Machine;
using Subsegments = std::span<const isa::Segment>;

constexpr double most_seconds = 1e6;
constexpr double most_clocks = 1e18;

/// The Program's subsegments, a span a segment of the picture.
std::vector<Subsegments> by_segment(const isa::Program& program, const Machine& machine) {
  Machine drawing = machine;
  drawing.picture = {program.shape.width, program.shape.height};
  std::vector<Subsegments> all;
  Subsegments left = program.segments;
  for (const isa::Region& segment : segments(drawing)) {
    const auto outside = [&](const isa::Segment& part) {
      return part.region.x < segment.x || part.region.x >= segment.x + segment.width || part.region.y < segment.y ||
             part.region.y >= segment.y + segment.height;
    };
    const auto count = std::find_if(left.begin(), left.end(), outside) - left.begin();
    all.push_back(left.first(static_cast<std::size_t>(count)));
    left = left.subspan(static_cast<std::size_t>(count));
  }
  return all;
}

bool active(Subsegments parts) {
  return std::any_of(parts.begin(), parts.end(), [](const isa::Segment& part) { return !part.instructions.empty(); });
}

/// What is broadcast and tested for a segment.
struct Division {
  std::uint64_t halfspace_tests = 0;
  std::uint64_t primitives = 0;
  std::uint64_t halfspaces = 0;
};

/// Half-spaces that are named, each once: C counts at the picture's top left.
std::uint64_t count_halfspaces(Subsegments parts) {
  std::vector<std::array<std::uint64_t, 4>> planes;
  for (const isa::Segment& part : parts) {
    for (const isa::Instruction& instruction : part.instructions) {
      const isa::Linear& linear = instruction.linear;
      if (linear.width == 0) continue;
      const auto a = static_cast<std::uint64_t>(linear.a);
      const auto b = static_cast<std::uint64_t>(linear.b);
      const auto c = static_cast<std::uint64_t>(linear.c);
      planes.push_back({a, b, c - a * part.region.x - b * part.region.y, linear.shift});
    }
  }
  std::sort(planes.begin(), planes.end());
  return static_cast<std::uint64_t>(std::unique(planes.begin(), planes.end()) - planes.begin());
}

Division division_of(Subsegments parts) {
  Division division;
  for (const isa::Segment& part : parts) {
    division.halfspace_tests = std::max<std::uint64_t>(division.halfspace_tests, part.facts.halfspaces);
    division.primitives = std::max<std::uint64_t>(division.primitives, part.facts.primitives);
  }
  if (!active(parts)) {
    division.primitives = 0;
    return division;
  }
  division.primitives = std::max<std::uint64_t>(division.primitives, 1);
  division.halfspaces = count_halfspaces(parts);
  return division;
}

std::uint64_t words_of(std::uint64_t bits, std::uint32_t word_bits) { return (bits + word_bits - 1) / word_bits; }

/// In words of so many bits, each command beginning at a word.
std::uint64_t list_words(const isa::Segment& part, std::uint32_t word_bits) {
  std::uint64_t words =
      words_of(isa::wire_bits(isa::SegmentStart{}), word_bits) + words_of(isa::wire_bits(isa::SegmentEnd{}), word_bits);
  for (const isa::Instruction& one : part.instructions) words += words_of(isa::wire_bits(one), word_bits);
  return words;
}

std::uint64_t data_words(const Division& division, const Figures& figures, std::uint32_t word_bits) {
  return division.primitives * words_of(figures.primitive_bits, word_bits) +
         division.halfspaces * words_of(figures.halfspace_bits, word_bits);
}

std::uint64_t& at(NodeClocks& clocks, NodeActivity activity) { return clocks.at(static_cast<std::size_t>(activity)); }
std::uint64_t& at(BusClocks& clocks, BusActivity activity) { return clocks.at(static_cast<std::size_t>(activity)); }
std::uint64_t& at(DisplayClocks& clocks, DisplayActivity activity) {
  return clocks.at(static_cast<std::size_t>(activity));
}

/// A frame, stage after stage.
class FrameModel {
 public:
  FrameModel(const isa::Program& program, const Machine& machine)
      : program_(program),
        machine_(machine),
        figures_(machines::own<Figures>(machine)),
        colour_(isa::field_of(program, isa::FieldRole::colour)) {
    counted_.nodes.resize(std::size_t{machine.array.width} * machine.array.height);
  }

  FrameClocks run() {
    transform();
    for (const Subsegments parts : by_segment(program_, machine_)) draw(parts);
    return {nodes_free_, complete()};
  }

 private:
  void transform() {
    const std::uint64_t clocks = program_.facts.model.halfspaces * figures_.transform_clocks;
    counted_.stages.transformation = clocks;
    display_free_ = clocks;
    nodes_free_ = clocks;
  }

  void draw(Subsegments parts) {
    const Division division = division_of(parts);
    const bool draws = active(parts);
    ++counted_.segments;
    divide(division);
    const std::uint64_t begun = broadcast(division);
    std::uint64_t now = begun;
    if (draws) {
      ++counted_.active_segments;
      now += prune(parts, division);
      now += share(parts);
      for (const isa::Segment& part : parts) now += render(part.instructions, part.region);
    } else {
      now += render({}, whole_of(parts));
    }
    nodes_free_ = now;
  }

  void divide(const Division& division) {
    const std::uint64_t boxes = program_.facts.model.primitives;
    const std::uint64_t clocks =
        boxes * figures_.display_tests.primitive + division.halfspace_tests * figures_.display_tests.halfspace;
    counted_.first_box_tests += boxes;
    counted_.first_halfspace_tests += division.halfspace_tests;
    counted_.stages.first_pruning += clocks;
    display_free_ = (figures_.divides_ahead ? display_free_ : std::max(display_free_, nodes_free_)) + clocks;
  }

  /// Returns when it is done.
  std::uint64_t broadcast(const Division& division) {
    const std::uint32_t width = machine_.link.width;
    const std::uint64_t words = words_of(isa::wire_bits(isa::SegmentStart{}), width) +
                                words_of(isa::wire_bits(isa::SegmentEnd{}), width) +
                                data_words(division, figures_, width);
    counted_.broadcast_primitives += division.primitives;
    counted_.broadcast_halfspaces += division.halfspaces;
    counted_.broadcast_words += words;
    for (NodeClocks& node : counted_.nodes) at(node, NodeActivity::receiving) += words * machine_.link.word_clocks;
    const std::uint64_t clocks = message(words);
    counted_.stages.broadcasting += clocks;
    display_free_ = std::max(display_free_, nodes_free_) + clocks;
    return display_free_;
  }

  /// Clocks of the bus.
  std::uint64_t message(std::uint64_t words) {
    at(counted_.bus, BusActivity::busy) += words * machine_.link.word_clocks;
    at(counted_.bus, BusActivity::granting) += machine_.link.latency;
    return machine_.link.latency + words * machine_.link.word_clocks;
  }

  std::uint64_t prune(Subsegments parts, const Division& division) {
    std::uint64_t slowest = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const std::uint64_t halfspaces = std::min<std::uint64_t>(division.halfspaces, parts[i].facts.halfspaces);
      const std::uint64_t clocks =
          division.primitives * figures_.node_tests.primitive + halfspaces * figures_.node_tests.halfspace;
      counted_.second_box_tests += division.primitives;
      counted_.second_halfspace_tests += halfspaces;
      at(counted_.nodes[i], NodeActivity::pruning) += clocks;
      slowest = std::max(slowest, clocks);
    }
    counted_.stages.second_pruning += slowest;
    return slowest + barrier();
  }

  std::uint64_t barrier() {
    counted_.stages.barriers += figures_.barrier_clocks;
    return figures_.barrier_clocks;
  }

  std::uint64_t share(Subsegments parts) {
    std::uint64_t clocks = 0;
    for (const isa::Segment& part : parts) {
      const std::uint64_t words = list_words(part, machine_.link.width);
      counted_.shared_words += words;
      clocks += message(words);
    }
    for (NodeClocks& node : counted_.nodes) at(node, NodeActivity::sharing) += clocks;
    counted_.stages.sharing += clocks;
    return clocks;
  }

  std::uint64_t render(std::span<const isa::Instruction> list, const isa::Region& region) {
    std::uint64_t slowest = 0;
    for (std::uint32_t i = 0; i < counted_.nodes.size(); ++i) {
      const NodePixels own = pixels_of(region, machine_.array, i / machine_.array.width, i % machine_.array.width);
      const std::uint64_t clocks = rendering_clocks(list, own, colour_, machine_);
      at(counted_.nodes[i], NodeActivity::rendering) += clocks;
      slowest = std::max(slowest, clocks);
    }
    counted_.stages.rendering += slowest;
    return slowest + barrier();
  }

  static isa::Region whole_of(Subsegments parts) {
    const isa::Region& first = parts.front().region;
    const isa::Region& last = parts.back().region;
    return {first.x, first.y, last.x + last.width - first.x, last.y + last.height - first.y};
  }

  FrameAccount complete() {
    const auto rest = [this](auto& clocks, auto waiting) {
      std::uint64_t spent = 0;
      for (const std::uint64_t one : clocks) spent += one;
      at(clocks, waiting) += nodes_free_ - spent;
    };
    at(counted_.display, DisplayActivity::transforming) = counted_.stages.transformation;
    at(counted_.display, DisplayActivity::dividing) = counted_.stages.first_pruning;
    at(counted_.display, DisplayActivity::broadcasting) = counted_.stages.broadcasting;
    rest(counted_.display, DisplayActivity::waiting_for_nodes);
    rest(counted_.bus, BusActivity::idle);
    for (NodeClocks& node : counted_.nodes) rest(node, NodeActivity::waiting);
    return counted_;
  }

  const isa::Program& program_;
  const Machine& machine_;
  const Figures& figures_;
  isa::Field colour_;
  FrameAccount counted_;
  std::uint64_t display_free_ = 0;  ///< when the display processor has sent what it has divided
  std::uint64_t nodes_free_ = 0;    ///< when they have rendered the segment
};

void check_memory(Subsegments parts, const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  std::uint64_t words = data_words(division_of(parts), figures, figures.word_bits);
  for (const isa::Segment& part : parts) words += list_words(part, figures.word_bits);
  if (words <= figures.memory_words) return;
  throw InputError(
      fmt::format("the segment at {},{} asks for {} words of a node, and the nodes of {} have {}; take a machine file "
                  "with more node.memory_words or subdivision.levels",
                  parts.front().region.x, parts.front().region.y, words, machine.name, figures.memory_words));
}

void check_time(const isa::Program& program, const Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const double primitives = static_cast<double>(program.facts.model.primitives);
  const double halfspaces = static_cast<double>(program.facts.model.halfspaces);
  double clocks = halfspaces * figures.transform_clocks;
  for (const isa::Segment& part : program.segments) {
    const double named = static_cast<double>(part.instructions.size());
    const double tested = part.facts.halfspaces;
    const double touching = part.facts.primitives + 1.0;
    const double words = static_cast<double>(list_words(part, machine.link.width)) + 100 +
                         touching * figures.primitive_bits + named * figures.halfspace_bits;
    clocks += primitives * figures.display_tests.primitive + tested * figures.display_tests.halfspace;
    clocks += touching * figures.node_tests.primitive + tested * figures.node_tests.halfspace;
    clocks += words * machine.link.word_clocks + 2.0 * machine.link.latency + 3.0 * figures.barrier_clocks;
    clocks += most_rendering_clocks(part.instructions, part.region, machine);
  }
  if (clocks <= most_clocks && clocks <= most_seconds * static_cast<double>(machine.clock_hz)) return;
  throw InputError(
      fmt::format("a frame may take {:.3g} clocks of {}, which is longer than is simulated; give it a smaller model or "
                  "picture, or faster figures",
                  clocks, machine.name));
}

}  // namespace

void check_fits(const isa::Program& program, const Machine& machine) {
  check_time(program, machine);
  for (const Subsegments parts : by_segment(program, machine)) check_memory(parts, machine);
}

FrameClocks time_stages(const isa::Program& program, const Machine& machine) {
  check_fits(program, machine);
  return FrameModel(program, machine).run();
}

FrameTiming time_frame(const isa::Program& program, const Machine& machine, std::span<const machines::Skip> /*skips*/) {
  const FrameClocks timing = time_stages(program, machine);
  return {.clocks = timing.clocks, .account = account(timing.account, machine.array)};
}

}  // namespace csgsim::multi_processor
