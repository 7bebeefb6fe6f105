#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "hw/isa/instruction.h"

namespace csgsim::isa {

/// What an opcode asks of the widths of its fields.
enum class FieldWidths : std::uint8_t {
  free,         ///< any width
  equal,        ///< all equally wide
  elementwise,  ///< all equally wide; these alone may coincide, but overlap in whole only
  one,          ///< one bit each
};

constexpr FieldWidths field_widths(Opcode opcode) {
  switch (opcode) {
    case Opcode::enable_all:
    case Opcode::enable_invert:
    case Opcode::enable_load:
    case Opcode::enable_and:
    case Opcode::enable_and_not:
    case Opcode::enable_or:
    case Opcode::enable_xor:
    case Opcode::enable_store: return FieldWidths::one;
    case Opcode::bit_and:
    case Opcode::bit_or:
    case Opcode::bit_xor:
    case Opcode::bit_and_not:
    case Opcode::bit_not: return FieldWidths::elementwise;
    case Opcode::copy:
    case Opcode::field_lt:
    case Opcode::field_le:
    case Opcode::field_eq: return FieldWidths::equal;
    case Opcode::edge_not_negative:
    case Opcode::edge_negative:
    case Opcode::linear_ge:
    case Opcode::linear_gt:
    case Opcode::linear_le:
    case Opcode::linear_lt:
    case Opcode::linear_eq:
    case Opcode::load_linear:
    case Opcode::keep_max:
    case Opcode::keep_min:
    case Opcode::set_constant:
    case Opcode::global_or:
    case Opcode::xor_constant:

    case Opcode::skip_if_none: return FieldWidths::free;
  }
  return FieldWidths::free;
}

constexpr bool is_field(OperandKind kind) { return kind == OperandKind::target || kind == OperandKind::source; }

constexpr bool has_operand(const OpcodeInfo& row, OperandKind kind) {
  return std::find(row.operands.begin(), row.operands.end(), kind) != row.operands.end();
}

/// Does it need the global OR of the machine?
constexpr bool asks(Opcode opcode) { return info(opcode).clock_class == ClockClass::answer; }

/// Instructions after this one that are not carried out, if so many pixels are enabled.
constexpr std::uint64_t skipped_after(const Instruction& instruction, std::uint64_t enabled_pixels) {
  return instruction.opcode == Opcode::skip_if_none && enabled_pixels == 0 ? instruction.constant : 0;
}

/// Is there a row for it? A value read from a file need not have one.
constexpr bool in_table(Opcode opcode) { return static_cast<std::size_t>(opcode) < opcode_table.size(); }
constexpr bool in_table(Purpose purpose) { return static_cast<std::size_t>(purpose) < purpose_table.size(); }

}  // namespace csgsim::isa
