#include "host/emit/divided.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <span>
#include <vector>

#include "host/emit/display_model.h"
#include "host/emit/division_counts.h"
#include "host/emit/preparation.h"
#include "hw/base/error.h"
#include "hw/division/encoding.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

std::vector<std::uint8_t> to_bytes(const division::Bits& bits) {
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>((bits.count + 7) / 8));
  for (std::size_t i = 0; i < bytes.size(); ++i)
    bytes[i] = static_cast<std::uint8_t>(bits.words[i / 8] >> (i % 8 * 8) & 0xffU);
  return bytes;
}

bool begins_surface(const isa::Instruction& one) {
  return one.opcode == isa::Opcode::enable_all && one.origin.purpose == isa::Purpose::render;
}

/// The primitive of the first surface. Setup instructions are counted with it, because the divider writes them
/// together.
std::uint32_t first_surface(const isa::Segment& segment) {
  const auto first = std::ranges::find_if(segment.instructions, begins_surface);
  return first == segment.instructions.end() ? model::no_index : first->origin.primitive;
}

/// Number of instructions of each surface.
std::map<std::uint32_t, std::uint64_t> count_instructions(const isa::Segment& segment) {
  std::map<std::uint32_t, std::uint64_t> counts;
  std::uint32_t surface = first_surface(segment);
  for (const isa::Instruction& one : segment.instructions) {
    if (begins_surface(one)) surface = one.origin.primitive;
    ++counts[surface];
  }
  return counts;
}

void store_counts(const SquareCounts& square, isa::Segment& segment) {
  std::map<std::uint32_t, std::uint64_t> instructions = count_instructions(segment);
  for (const SurfaceCounts& surface : square) {
    isa::DivisionStep step = surface.counts;
    step.instructions = instructions[surface.primitive];
    if (surface.primitive != model::no_index || step != isa::DivisionStep{}) segment.division->steps.push_back(step);
  }
}

std::vector<isa::Region> list_regions(std::span<const isa::Segment> segments) {
  std::vector<isa::Region> regions;
  for (const isa::Segment& segment : segments) regions.push_back(segment.region);
  return regions;
}

/// Whether the group contains the region.
bool contains(const isa::Region& group, const isa::Region& region) {
  return region.x >= group.x && region.x - group.x < group.width && region.y >= group.y &&
         region.y - group.y < group.height;
}

/// The group of `width` x `height` pixels that contains the region, clipped to the picture.
isa::Region enclosing_group(const isa::Region& region, const isa::ArrayShape& picture, std::uint32_t width,
                            std::uint32_t height) {
  const std::uint32_t x = region.x / width * width;
  const std::uint32_t y = region.y / height * height;
  return {x, y, std::min(width, picture.width - x), std::min(height, picture.height - y)};
}

}  // namespace

Options options_for_division(const machines::Division& /*division*/, const Options& options) {
  if (options.strategy != Strategy::stack && options.strategy != Strategy::automatic) {
    throw InputError(fmt::format(
        "the machine divides the model itself, and its divider supports only --strategy stack, not {}; take that, "
        "or a machine for which the host divides",
        name_of(options.strategy)));
  }
  Options divided = divider_options(options);
  if (options.pruning != csg::Pruning{} && options.pruning != divided.pruning) {
    throw InputError(
        "the machine divides the model itself, with fixed prunings; turn none of them off, or take a "
        "machine for which the host divides");
  }
  return divided;
}

void add_division(isa::Program& program, const machines::Division& division, const model::Tree& tree,
                  const facet::Geometry& geometry, const view::View& view, const machines::Machine& machine,
                  const Options& options) {
  *program.preparation = count_preparation(geometry, view, count_distinct_numbers(geometry));
  *program.model_preparation = count_sharing_work(geometry);
  program.facts->prunings.clear();
  program.display_model = to_bytes(division::encode(make_display_model(
      tree, geometry, view, options, program.shape.memory_bits, csg::Counted(*program.preparation))));
  const std::span<isa::Segment> segments = program.segments;
  // The machine divides the model into the segments, so that the host does no work for them.
  for (isa::Segment& segment : segments) *segment.preparation = {};
  if (division.group_side == 0 && division.groups.empty()) {
    const auto counts = count_division(tree, geometry, view, options, list_regions(segments));
    for (std::size_t i = 0; i < segments.size(); ++i) store_counts(counts[i], segments[i]);
    return;
  }
  const auto group_at = [&](std::size_t index) {
    return enclosing_group(segments[index].region, program.shape,
                           std::max(1U, division.group_side * machine.array.width),
                           std::max(1U, division.group_side * machine.array.height));
  };
  std::size_t turn = 0;
  for (std::size_t first = 0, next = 0; first < segments.size(); first = next) {
    const isa::Region group = division.groups.empty() ? group_at(first) : division.groups.at(turn++);
    const auto outside = [&](const isa::Segment& segment) { return !contains(group, segment.region); };
    const auto end = std::find_if(segments.begin() + static_cast<std::ptrdiff_t>(first), segments.end(), outside);
    next = static_cast<std::size_t>(end - segments.begin());
    const std::span<isa::Segment> squares = segments.subspan(first, next - first);
    const std::vector<isa::Region> regions = list_regions(squares);
    const GroupCounts counts = count_group_division(tree, geometry, view, options, group, regions);
    const bool fits = counts.entries <= division.list_entries;
    const auto square_counts = fits ? counts.squares : count_division(tree, geometry, view, options, regions);
    for (std::size_t i = 0; i < squares.size(); ++i) store_counts(square_counts[i], squares[i]);
    isa::DivisionCounts& group_counts = *squares.front().division;
    group_counts.group_boxes = counts.group.boxes;
    group_counts.group_lists = counts.group.lists;
    group_counts.group_halfspaces = counts.group.halfspaces;
    group_counts.group_cells = counts.group.cells;
    group_counts.group_entries = counts.entries;
  }
}

}  // namespace csgsim::emit
