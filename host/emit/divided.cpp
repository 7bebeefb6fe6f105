#include "host/emit/divided.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <vector>

#include "host/emit/display_model.h"
#include "host/emit/division_counts.h"
#include "hw/base/error.h"
#include "hw/division/encoding.h"

namespace csgsim::emit {

namespace {

std::vector<std::uint8_t> bytes_of(const division::Bits& bits) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>((bits.count + 7) / 8));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(bits.words[i / 8] >> (i % 8 * 8) & 0xffU);
  return bytes;
}

void put(const SquareCounts& square, isa::Segment& segment) {
  const division::Counts& counts = square.counts;
  isa::DivisionFacts& facts = segment.facts.division;
  facts.boxes = counts.boxes;
  facts.halfspaces = counts.halfspaces;
  facts.cells = counts.cells;
  facts.nodes = counts.nodes;
  facts.most_halfspaces = square.at_hand.halfspaces;
  facts.most_nodes = square.at_hand.nodes;
}

std::vector<isa::Region> regions_of(std::span<const isa::Segment> segments) {
  std::vector<isa::Region> regions;
  for (const isa::Segment& segment : segments) regions.push_back(segment.region);
  return regions;
}

/// The group of so many pixels that holds the region, cut off at the picture's edges.
isa::Region group_of(const isa::Region& region, const isa::ArrayShape& picture, std::uint32_t width,
                     std::uint32_t height) {
  const std::uint32_t x = region.x / width * width;
  const std::uint32_t y = region.y / height * height;
  return {x, y, std::min(width, picture.width - x), std::min(height, picture.height - y)};
}

}  // namespace

Options options_for(const machines::Division& /*division*/, const Options& options) {
  if (options.strategy != Strategy::stack && options.strategy != Strategy::automatic) {
    throw InputError(
        fmt::format("the machine divides the model itself, by the strategy stack alone, not {}; take that, "
                    "or a machine whose divider.kind is host",
                    name_of(options.strategy)));
  }
  const Options divided = divider_options(options);
  if (options.pruning != csg::Pruning{} && options.pruning != divided.pruning) {
    throw InputError(
        "the machine divides the model itself, with prunings of its own; leave out none of them, or take a "
        "machine whose divider.kind is host");
  }
  return divided;
}

void add_division(isa::Program& program, const machines::Division& division, const model::Tree& tree,
                  const facet::Scene& scene, const view::View& view, const machines::Machine& machine,
                  const Options& options) {
  program.display_model =
      bytes_of(division::encode(make_display_model(tree, scene, view, options, program.shape.memory_bits)));
  const std::span<isa::Segment> segments = program.segments;
  if (division.group_side == 0) {
    const auto counts = count_division(tree, scene, view, options, regions_of(segments));
    for (std::size_t i = 0; i < segments.size(); ++i) put(counts[i], segments[i]);
    return;
  }
  const auto group_at = [&](std::size_t index) {
    return group_of(segments[index].region, program.shape, division.group_side * machine.array.width,
                    division.group_side * machine.array.height);
  };
  for (std::size_t first = 0, next = 0; first < segments.size(); first = next) {
    const isa::Region group = group_at(first);
    while (next < segments.size() && group_at(next) == group) ++next;
    const std::span<isa::Segment> squares = segments.subspan(first, next - first);
    const std::vector<isa::Region> regions = regions_of(squares);
    const GroupCounts counts = count_group(tree, scene, view, options, group, regions);
    const bool fits = counts.entries <= division.list_entries;
    const auto of_squares = fits ? counts.squares : count_division(tree, scene, view, options, regions);
    for (std::size_t i = 0; i < squares.size(); ++i) put(of_squares[i], squares[i]);
    squares.front().facts.division.group_boxes = counts.group.boxes;
    squares.front().facts.division.group_halfspaces = counts.group.halfspaces;
    squares.front().facts.division.group_cells = counts.group.cells;
  }
}

}  // namespace csgsim::emit
