// The table of the instruction set.
// Used by hw, host/effects, host/emit and sim.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "hw/isa/opcode.h"

namespace csgsim::isa {

/// Constraints on the widths of an instruction's fields.
enum class FieldWidths : std::uint8_t {
  free,         ///< any width
  equal,        ///< all of the same width
  elementwise,  ///< all of the same width; only these fields may coincide, but not overlap in part
  one,          ///< one bit each
  narrower,     ///< the second no wider than the first
  wide,         ///< any width up to max_wide_field_width
  odd,          ///< an odd width from 3 up to max_wide_field_width
};

/// The number of clocks of an instruction (hw/machines/clocks.h has the parameters).
enum class ClockClass : std::uint8_t {
  one,           ///< one bit step
  linear_once,   ///< the linear expression is streamed once: one bit step per group of bits that the trees deliver
  linear_twice,  ///< streamed once to compare, once to write
  field,         ///< one bit step per group of field bits that the ALU processes in a clock
  two_fields,    ///< as `field`, with two memory reads of the source fields
  answer,        ///< one bit step, then the controller waits for the global OR
  root,          ///< one bit of the root after another, each using all earlier root bits
};

/// Effect of an instruction on E.
enum class EnableEffect : std::uint8_t {
  sets,     ///< independent of the old value
  narrows,  ///< may clear E
  keeps,
};

/// The broadcast instruction set. Columns: number, name, operands (at most three), widths of the fields, clock class,
/// effect on E, meaning. Files and links carry the numbers, so a number never changes; the order of the rows is free.
///
/// In the meanings E is the pixel's enable bit, t a target field, s and r source fields, k a constant or a count, and
/// F the pixel's value of the linear expression: the low `width` bits of A*x + B*y + C as a two's complement number,
/// shifted right by `shift` with floor; x and y are the pixel's column and row in its segment. After `squares` the sum
/// also contains A*x*x + B*x*y + C*y*y with the coefficients of the squares. Fields are unsigned. D is the value of a
/// field of 2w + 1 bits without its top bit. Memory is written only where E is 1, except by enable_store.
// clang-format off
#define CSGSIM_OPCODES(OP)                                                                                             \
  OP( 0, enable_all,        none,   none,     none,   one,         one,         sets,    "E := 1")                     \
  OP( 1, enable_invert,     none,   none,     none,   one,         one,         sets,    "E := not E")                 \
  OP( 2, enable_load,       source, none,     none,   one,         one,         sets,    "E := s")                     \
  OP( 3, enable_and,        source, none,     none,   one,         one,         narrows, "E := E and s")               \
  OP( 4, enable_and_not,    source, none,     none,   one,         one,         narrows, "E := E and not s")           \
  OP( 5, enable_or,         source, none,     none,   one,         one,         sets,    "E := E or s")                \
  OP( 6, enable_xor,        source, none,     none,   one,         one,         sets,    "E := E xor s")               \
  OP( 7, enable_store,      target, none,     none,   one,         one,         keeps,                                 \
     "t := E, at every pixel, enabled or not")                                                                         \
  OP( 8, edge_not_negative, linear, none,     none,   free,        linear_once, narrows, "E := E and F >= 0")          \
  OP( 9, edge_negative,     linear, none,     none,   free,        linear_once, narrows, "E := E and F < 0")           \
  OP(10, linear_ge,         source, linear,   none,   free,        linear_once, narrows, "E := E and F >= s")          \
  OP(11, linear_gt,         source, linear,   none,   free,        linear_once, narrows, "E := E and F > s")           \
  OP(12, linear_le,         source, linear,   none,   free,        linear_once, narrows, "E := E and F <= s")          \
  OP(13, linear_lt,         source, linear,   none,   free,        linear_once, narrows, "E := E and F < s")           \
  OP(14, linear_eq,         source, linear,   none,   free,        linear_once, narrows, "E := E and F = s")           \
  OP(15, load_linear,       target, linear,   none,   wide,        linear_once, narrows,                               \
     "where E: t := the low bits of F, and E := 0 if F does not fit t")                                                \
  OP(16, keep_max,          target, linear,   none,   free,        linear_twice, narrows,                              \
     "where E and F > t: t := the low bits of F, and E := 0 if F does not fit t")                                      \
  OP(17, keep_min,          target, linear,   none,   free,        linear_twice, narrows,                              \
     "where E and F < t: t := the low bits of F, and E := 0 if F does not fit t")                                      \
  OP(18, set_constant,      target, constant, none,   free,        field,       keeps,   "where E: t := k")            \
  OP(19, copy,              target, source,   none,   equal,       field,       keeps,   "where E: t := s")            \
  OP(20, field_lt,          source, source,   none,   equal,       two_fields,  narrows, "E := E and s < r")           \
  OP(21, field_le,          source, source,   none,   equal,       two_fields,  narrows, "E := E and s <= r")          \
  OP(22, field_eq,          source, source,   none,   equal,       two_fields,  narrows, "E := E and s = r")           \
  OP(23, bit_and,           target, source,   source, elementwise, two_fields,  keeps,                                 \
     "where E: t := s and r, bit by bit")                                                                              \
  OP(24, bit_or,            target, source,   source, elementwise, two_fields,  keeps,                                 \
     "where E: t := s or r, bit by bit")                                                                               \
  OP(25, bit_xor,           target, source,   source, elementwise, two_fields,  keeps,                                 \
     "where E: t := s xor r, bit by bit")                                                                              \
  OP(26, bit_and_not,       target, source,   source, elementwise, two_fields,  keeps,                                 \
     "where E: t := s and not r, bit by bit")                                                                          \
  OP(27, bit_not,           target, source,   none,   elementwise, field,       keeps,                                 \
     "where E: t := not s, bit by bit")                                                                                \
  OP(28, global_or,         none,   none,     none,   free,        answer,      keeps,                                 \
     "the host receives whether E is 1 at any pixel")                                                                  \
  OP(29, xor_constant,      target, constant, none,   free,        field,       keeps,                                 \
     "where E: t := t xor k, bit by bit")                                                                              \
  OP(30, skip_if_none,      count,  none,     none,   free,        answer,      keeps,                                 \
     "if E is 1 at no pixel, the next k instructions of the segment are not executed")                                 \
  OP(31, add,               target, source,   none,   narrower,    two_fields,  keeps,                                 \
     "where E: t := the low bits of t + s; the carry out of the top bit is lost")                                      \
  OP(32, stripe,            linear, none,     none,   free,        linear_once, narrows,                               \
     "E := E and the top bit of F; bits of the sum above it are cut off on purpose, which is no overflow")             \
  OP(33, squares,           squares, none,    none,   free,        one,         keeps,                                 \
     "adds A x^2 + B xy + C y^2 to the sum of the next instruction")                                                   \
  OP(34, linear_plus,       target, linear,   none,   wide,        linear_once, keeps,                                 \
     "where E: t := the low bits of F + t")                                                                            \
  OP(35, linear_minus,      target, linear,   none,   wide,        linear_once, keeps,                                 \
     "where E: t := the low bits of F - t")                                                                            \
  OP(36, root,              target, none,     none,   odd,         root,        keeps,                                 \
     "where E: t := q, the root of D rounded down, in its upper w bits, and D - (q or 1)^2 below")
// clang-format on

enum class Opcode : std::uint8_t {
#define CSGSIM_OPCODE_ENUMERATOR(number, name, ...) name = number,
  CSGSIM_OPCODES(CSGSIM_OPCODE_ENUMERATOR)
#undef CSGSIM_OPCODE_ENUMERATOR
};

/// One row of the table.
struct OpcodeInfo {
  Opcode opcode;
  std::string_view name;
  Operands operands;
  FieldWidths widths;
  ClockClass clock_class;
  EnableEffect enable_effect;
  std::string_view meaning;
};

inline constexpr auto opcode_table = std::to_array<OpcodeInfo>({
// clang-format off
#define CSGSIM_OPCODE_ROW(number, name, first, second, third, widths, clocks, enable, meaning)    \
    OpcodeInfo{Opcode::name, #name, {OperandKind::first, OperandKind::second, OperandKind::third}, \
               FieldWidths::widths, ClockClass::clocks, EnableEffect::enable, meaning},
    // clang-format on
    CSGSIM_OPCODES(CSGSIM_OPCODE_ROW)
#undef CSGSIM_OPCODE_ROW
});

/// The row index for each number; opcode_table.size() for unused numbers.
inline constexpr auto opcode_rows = [] {
  std::array<std::uint8_t, opcode_numbers> rows{};
  rows.fill(static_cast<std::uint8_t>(opcode_table.size()));
  for (std::size_t row = 0; row < opcode_table.size(); ++row)
    rows.at(static_cast<std::size_t>(opcode_table[row].opcode)) = static_cast<std::uint8_t>(row);
  return rows;
}();

/// The row of an opcode in the table.
constexpr const OpcodeInfo& info(Opcode opcode) { return opcode_table[opcode_rows[static_cast<std::size_t>(opcode)]]; }

/// Whether the instruction may change E or memory of a disabled pixel.
constexpr bool acts_on_disabled(Opcode opcode) {
  return info(opcode).enable_effect == EnableEffect::sets || opcode == Opcode::enable_store;
}

static_assert(
    [] {
      for (const OpcodeInfo& row : opcode_table)
        if (static_cast<std::size_t>(row.opcode) >= opcode_numbers) return false;
      return true;
    }(),
    "an opcode's number fits opcode_bits");
static_assert(
    [] {
      for (const OpcodeInfo& row : opcode_table)
        if (info(row.opcode).name != row.name) return false;
      return true;
    }(),
    "no two opcodes share a number");
static_assert(Opcode{} == Opcode::enable_all, "an Instruction begins as this one");

}  // namespace csgsim::isa
