#include "hw/multi_processor/timing_parts.h"

#include <algorithm>
#include <initializer_list>
#include <span>

#include "hw/base/quotient.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/wire.h"
#include "hw/multi_processor/clocks.h"
#include "hw/multi_processor/figures.h"
#include "hw/multi_processor/regions.h"

namespace csgsim::multi_processor {

std::vector<Subsegments> subsegments_by_segment(const isa::Program& program, const machines::Machine& machine) {
  const std::uint32_t levels = machines::kind_figures<Figures>(machine).levels;
  std::vector<Subsegments> all;
  Subsegments left = program.segments;
  for (const isa::Region& segment : picture_segments({program.shape.width, program.shape.height}, levels)) {
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

/// Each subsegment tests all primitives that survive in the segment.
SegmentDivision segment_division(Subsegments parts) {
  const isa::DivisionCounts& counts = *parts.front().division;
  const std::uint64_t boxes = counts.sum().boxes;
  const bool draws =
      std::any_of(parts.begin(), parts.end(), [](const isa::Segment& part) { return !part.instructions.empty(); });
  return {.active = draws || boxes > 0,
          .boxes = counts.group_boxes,
          .halfspace_tests = counts.group_halfspaces,
          .cell_tests = counts.group_cells,
          .primitives = boxes,
          .halfspaces = counts.group_entries - std::min(boxes, counts.group_entries)};
}

TestClocks node_test_clocks(const ModelSizes& sizes, const Figures& figures) {
  const auto bits = [](std::uint32_t width) { return static_cast<std::uint8_t>(width); };
  constexpr std::uint8_t side = 15;
  const std::uint8_t depth = bits(sizes.depth + 1);
  const auto more = [&](std::uint32_t& clocks, std::initializer_list<std::uint8_t> widths) {
    clocks += static_cast<std::uint32_t>(unpacking_clocks(std::span(widths.begin(), widths.size()), figures));
  };
  TestClocks each = figures.node_tests;
  more(each.primitive, {side, side, side, side, depth, depth});
  more(each.halfspace, {1, 1, bits(sizes.slope), bits(sizes.slope), bits(sizes.constant)});
  more(each.tree_node, {1, 1, bits(sizes.operands)});
  return each;
}

std::uint64_t list_words(const isa::Segment& part, std::uint32_t word_bits) {
  std::uint64_t words = quotient_up(isa::wire_bits(isa::SegmentStart{}), word_bits) +
                        quotient_up(isa::wire_bits(isa::SegmentEnd{}), word_bits);
  for (const isa::Instruction& one : part.instructions) words += quotient_up(isa::wire_bits(one), word_bits);
  return words;
}

namespace {

std::uint64_t host_bits(const isa::Program& program) {
  constexpr std::uint64_t length = 32;
  return length + 8 * std::uint64_t{program.display_model.size()};
}

}  // namespace

std::uint64_t host_words(const isa::Program& program, std::uint32_t word_bits) {
  return quotient_up(host_bits(program), word_bits);
}

bool DisplayMemory::can_hold(const SegmentDivision& division, const ModelSizes& sizes, const Figures& figures) const {
  const std::uint64_t left = segment_words(sizes, division.primitives, division.halfspaces, figures.word_bits);
  return model_words + left <= figures.display_memory_words;
}

DisplayMemory display_memory(const isa::Program& program, const ModelSizes& sizes, const Figures& figures) {
  const std::uint64_t whole = host_words(program, figures.word_bits);
  if (whole <= figures.display_memory_words) return {whole, true};
  const std::uint64_t planes = std::min(sizes.planes * plane_bits(sizes), host_bits(program));
  return {quotient_up(host_bits(program) - planes, figures.word_bits), false};
}

std::uint64_t remote_plane_clocks(const ModelSizes& sizes, const Figures& figures) {
  const HostLink& host = figures.host;
  return host.latency + quotient_up(plane_bits(sizes), host.width) * host.word_clocks + figures.transform_clocks;
}

}  // namespace csgsim::multi_processor
