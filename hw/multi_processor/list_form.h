#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>

#include "hw/isa/instruction.h"
#include "hw/isa/wire.h"

/// How the lists of a segment are written down, on the bus and in the nodes' memories.
///
/// As instructions, they are what crosses any link (hw/isa/wire.h). As numbers, a linear expression of a half-space
/// that all nodes have is its number among those that the segment leaves, and the width of the expression: after the
/// instruction's own number and its field comes a bit that says so, and these two; else the bit, and the expression.
namespace csgsim::multi_processor {

struct ListForm {
  bool has_numbers = false;
  unsigned number_bits = 0;                      ///< of a half-space
  unsigned record_bits = 0;                      ///< of a half-space in memory
  std::array<std::uint8_t, 5> record_numbers{};  ///< bits of what is looked at of that
};

/// Bits of the width beside a number.
inline constexpr unsigned number_width_bits = isa::wire_linear_width_bits;

/// Is the expression a half-space's? Those that clip to a rectangle, at most a step a pixel across or down, are none,
/// nor is 0; a line of a half-space like these travels as they do.
inline bool is_of_halfspace(const isa::Instruction& instruction) {
  if (instruction.linear.width == 0) return false;
  const isa::Linear linear = isa::reduced(instruction.linear);
  if (instruction.fields[0].width > 0) return linear.a != 0 || linear.b != 0 || linear.c != 0;
  constexpr std::int64_t step = 1;
  return linear.a < -step || linear.a > step || linear.b < -step || linear.b > step || (linear.a != 0 && linear.b != 0);
}

/// Does its number travel?
inline bool is_named(const isa::Instruction& instruction, const ListForm& form) {
  return form.has_numbers && is_of_halfspace(instruction);
}

}  // namespace csgsim::multi_processor
