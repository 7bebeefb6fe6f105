#include "hw/pixel_square/division_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string_view>
#include <vector>

#include "hw/base/error.h"
#include "hw/division/divide.h"
#include "hw/division/encoding.h"
#include "hw/division/groups.h"
#include "hw/isa/wire.h"
#include "hw/pixel_square/figures.h"

namespace csgsim::pixel_square {

namespace {

division::Divider divider_of(const isa::Program& program) {
  constexpr unsigned byte_bits = 8;
  std::vector<isa::LinkWord> words(program.display_model.size());
  for (std::size_t i = 0; i < words.size(); ++i) words[i].put(0, byte_bits, program.display_model[i]);
  return division::Divider(division::from_link(words, byte_bits));
}

bool alike(const isa::Instruction& one, const isa::Instruction& other) {
  return isa::as_received(one) == isa::as_received(other);
}

void check_instructions(const std::vector<isa::Instruction>& divided, const isa::Segment& segment, std::size_t index) {
  const std::vector<isa::Instruction>& expected = segment.instructions;
  if (std::equal(divided.begin(), divided.end(), expected.begin(), expected.end(), alike)) return;
  throw InputError(
      fmt::format("segment {} is not what its display model is divided into; compile the model again", index));
}

/// The squares of a group, at the machine's levels.
std::vector<division::Divided> divide(const division::Divider& divider, const division::Group& group,
                                      std::span<const isa::Region> regions, const Figures& figures) {
  std::vector<isa::Region> squares;
  squares.reserve(group.squares.size());
  for (const std::size_t index : group.squares) squares.push_back(regions[index]);
  if (figures.levels == 2) return division::divide_group(divider, group.region, squares, figures.list_entries).squares;
  std::vector<division::Divided> divided;
  divided.reserve(squares.size());
  for (const isa::Region& square : squares) divided.push_back(divider.divide(square));
  return divided;
}

std::uint64_t command_words(const isa::Segment& square, std::uint32_t width) {
  if (square.instructions.empty()) return 0;
  std::uint64_t words =
      isa::wire_words(isa::SegmentStart{square.region}, width) + isa::wire_words(isa::SegmentEnd{}, width);
  for (const isa::Instruction& instruction : square.instructions) words += isa::wire_words(instruction, width);
  return words;
}

}  // namespace

void check_division(const isa::Program& program, const machines::Machine& machine) {
  const Figures& figures = machines::own<Figures>(machine);
  if (figures.divider == DividerKind::host) return;
  const division::Divider divider = divider_of(program);
  const division::DisplayModel& model = divider.model();
  if (model.width != program.shape.width || model.height != program.shape.height)
    throw InputError("the Program's picture is not that of its display model; compile the model again");
  std::vector<isa::Region> regions;
  for (const isa::Segment& segment : program.segments) regions.push_back(segment.region);
  const std::uint32_t side = figures.levels == 2 ? figures.group_side : 1;
  for (const division::Group& group : division::groups_of(regions, program.shape, machine.array, side, side)) {
    const std::vector<division::Divided> divided = divide(divider, group, regions, figures);
    for (std::size_t i = 0; i < divided.size(); ++i) {
      const isa::Segment& segment = program.segments[group.squares[i]];
      check_instructions(divided[i].instructions, segment, group.squares[i]);
      check_storage(segment, divided[i].at_hand, machine);
    }
  }
}

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

}  // namespace csgsim::pixel_square
