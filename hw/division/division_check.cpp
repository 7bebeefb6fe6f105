#include "hw/division/division_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "hw/base/error.h"
#include "hw/division/divide.h"
#include "hw/division/encoding.h"
#include "hw/isa/wire.h"

namespace csgsim::division {

namespace {

bool same_encoding(const isa::Instruction& one, const isa::Instruction& other) {
  return isa::as_received(one) == isa::as_received(other);
}

void check_square(const isa::Segment& segment, std::size_t index, const SquareDivision& divided) {
  const std::vector<isa::Instruction>& expected = segment.instructions;
  if (!std::equal(divided.instructions.begin(), divided.instructions.end(), expected.begin(), expected.end(),
                  same_encoding)) {
    throw InputError(
        fmt::format("segment {} does not match the division of its display model; compile the model again", index));
  }
}

}  // namespace

DisplayModel display_model_of(std::span<const std::uint8_t> bytes) {
  constexpr unsigned byte_bits = 8;
  std::vector<isa::LinkWord> words(bytes.size());
  for (std::size_t i = 0; i < words.size(); ++i) words[i].put(0, byte_bits, bytes[i]);
  return from_link(words, byte_bits);
}

void check_division(const isa::Program& program) { check_division(program, {}, 0); }

void check_division(const isa::Program& program, std::span<const Group> groups, std::uint64_t list_entries) {
  const DisplayModel model = display_model_of(program.display_model);
  const Divider divider(model);
  PlainDatapath path(model);
  if (model.width != program.shape.width || model.height != program.shape.height)
    throw InputError("the pictures of the Program and of its display model differ in size; compile the model again");
  if (groups.empty()) {
    for (std::size_t i = 0; i < program.segments.size(); ++i)
      check_square(program.segments[i], i, divider.divide(program.segments[i].region, path));
  }
  for (const Group& group : groups) {
    std::vector<isa::Region> squares;
    for (const std::size_t index : group.squares) squares.push_back(program.segments[index].region);
    const std::vector<SquareDivision> divided =
        divide_group(divider, group.region, squares, list_entries, path).squares;
    for (std::size_t i = 0; i < divided.size(); ++i)
      check_square(program.segments[group.squares[i]], group.squares[i], divided[i]);
  }
}

}  // namespace csgsim::division
