#include "hw/pixel_square/division_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "hw/base/error.h"
#include "hw/division/divide.h"
#include "hw/division/encoding.h"
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

}  // namespace

void check_division(const isa::Program& program, const machines::Machine& machine) {
  if (machines::own<Figures>(machine).divider == DividerKind::host) return;
  const division::Divider divider = divider_of(program);
  const division::DisplayModel& model = divider.model();
  if (model.width != program.shape.width || model.height != program.shape.height)
    throw InputError("the Program's picture is not that of its display model; compile the model again");
  for (std::size_t i = 0; i < program.segments.size(); ++i) {
    const std::vector<isa::Instruction>& expected = program.segments[i].instructions;
    const std::vector<isa::Instruction> divided = divider.divide(program.segments[i].region).instructions;
    if (!std::equal(divided.begin(), divided.end(), expected.begin(), expected.end(), alike)) {
      throw InputError(
          fmt::format("segment {} is not what its display model is divided into; compile the model again", i));
    }
  }
}

}  // namespace csgsim::pixel_square
