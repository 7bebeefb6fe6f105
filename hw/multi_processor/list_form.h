#pragma once

#include <array>
#include <cstdint>
#include <cstdlib>

#include "hw/isa/instruction.h"
#include "hw/isa/wire.h"

/// Encoding of the lists of a segment, on the bus and in the nodes' memories.
///
/// Form `instructions`: lists are encoded as on any link (hw/isa/wire.h). Form `numbers`: the linear expression of a
/// half-space that all nodes hold is replaced by the half-space's index among the survivors of the segment and the
/// width of the expression. A flag bit follows the opcode and the field: 1 is followed by index and width, 0 by the
/// expression.
namespace csgsim::multi_processor {

struct ListForm {
  bool has_numbers = false;
  unsigned number_bits = 0;                      ///< width of the index of a half-space
  unsigned record_bits = 0;                      ///< width of a half-space in memory
  std::array<std::uint8_t, 5> record_numbers{};  ///< widths in bits of the numbers read from that record
};

/// Bits of the width that follows an index.
inline constexpr unsigned number_width_bits = isa::wire_linear_width_bits;

/// Whether the expression belongs to a half-space. Expressions that clip to a rectangle, which change by at most one
/// step per pixel in x or y, do not, nor does 0; the expression of a half-space that has one of these forms is
/// sent like them.
inline bool is_halfspace_expression(const isa::Instruction& instruction) {
  if (instruction.linear.width == 0) return false;
  const isa::Linear linear = isa::reduced(instruction.linear);
  if (instruction.fields[0].width > 0) return linear.a != 0 || linear.b != 0 || linear.c != 0;
  constexpr std::int64_t step = 1;
  return linear.a < -step || linear.a > step || linear.b < -step || linear.b > step || (linear.a != 0 && linear.b != 0);
}

/// Whether the half-space's index is sent instead of the expression.
inline bool uses_index(const isa::Instruction& instruction, const ListForm& form) {
  return form.has_numbers && is_halfspace_expression(instruction);
}

}  // namespace csgsim::multi_processor
