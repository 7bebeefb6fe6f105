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

bool alike(const isa::Instruction& one, const isa::Instruction& other) {
  return isa::as_received(one) == isa::as_received(other);
}

}  // namespace

DisplayModel display_model_of(std::span<const std::uint8_t> bytes) {
  constexpr unsigned byte_bits = 8;
  std::vector<isa::LinkWord> words(bytes.size());
  for (std::size_t i = 0; i < words.size(); ++i) words[i].put(0, byte_bits, bytes[i]);
  return from_link(words, byte_bits);
}

void check_division(const isa::Program& program) {
  const Divider divider(display_model_of(program.display_model));
  const DisplayModel& model = divider.model();
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

}  // namespace csgsim::division
