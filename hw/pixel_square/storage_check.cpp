#include "hw/pixel_square/storage_check.h"

#include <fmt/format.h>

#include <string_view>
#include <vector>

#include "hw/base/error.h"
#include "hw/division/division_check.h"
#include "hw/isa/wire.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

std::uint64_t command_words(const isa::Segment& square, std::uint32_t width) {
  if (square.instructions.empty()) return 0;
  std::uint64_t words =
      isa::wire_words(isa::SegmentStart{square.region}, width) + isa::wire_words(isa::SegmentEnd{}, width);
  for (const isa::Instruction& instruction : square.instructions) words += isa::wire_words(instruction, width);
  return words;
}

/// The groups that the machine's divider makes; none for one level.
std::vector<division::Group> groups_of(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  if (figures.levels < 2) return {};
  std::vector<isa::Region> regions;
  regions.reserve(program.segments.size());
  for (const isa::Segment& segment : program.segments) regions.push_back(segment.region);
  return division::groups_of(regions, program.shape, machine.array, figures.group_side, figures.group_side);
}

}  // namespace

void check_storage(const isa::Segment& square, const division::AtHand& at_hand, const machines::Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  const auto require = [&](std::uint64_t needed, std::uint64_t there, std::string_view of, std::string_view figure) {
    if (needed <= there) return;
    throw InputError(
        fmt::format("the square at {},{} has {} {}, and the divider keeps {}; give {} more, or the model "
                    "fewer faces",
                    square.region.x, square.region.y, needed, of, there, figure));
  };
  require(at_hand.halfspaces, figures.halfspaces, "half-spaces to look at for one surface", "divider.halfspaces");
  require(at_hand.nodes, figures.nodes, "nodes of the tree to look at for one surface", "divider.nodes");
  require(command_words(square, machine.link.width), figures.store_words, "words of commands", "divider.store");
}

void check_division(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  if (figures.divider == DividerKind::host) return;
  division::check_division(
      program, groups_of(program, machine), figures.list_entries,
      [&](const isa::Segment& square, const division::AtHand& at_hand) { check_storage(square, at_hand, machine); });
}

}  // namespace csgsim::pixel_square
