#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace csgsim::isa {

/// What an operand of an instruction is.
enum class OperandKind : std::uint8_t {
  none,
  target,    ///< a field of pixel memory that is written
  source,    ///< a field of pixel memory that is read
  linear,    ///< A, B, C, width, shift of a linear expression
  constant,  ///< an unsigned constant as wide as the target field
  count,     ///< a number of instructions, 1 at least
};

/// How many clocks an instruction takes (see hw/machines/clocks.h for the figures).
enum class ClockClass : std::uint8_t {
  one,           ///< one bit step
  linear_once,   ///< the linear expression is streamed once: its width
  linear_twice,  ///< streamed once to compare, once to write: twice its width
  field,         ///< one bit step a bit of the target field, or for as many as the ALU is wide
  two_fields,    ///< as `field`, with two memory reads of the source fields
  answer,        ///< one bit step, then the controller waits for the answer
};

/// The broadcast instruction set. Columns: opcode, operands (at most three), clock class, meaning.
///
/// In the meanings E is the pixel's enable bit, t a target field, s and r source fields, k a constant or a count, and
/// F the pixel's value of the linear expression: the low `width` bits of A*x + B*y + C as a two's complement number,
/// shifted right by `shift` with floor; x and y are the pixel's column and row in its segment. Fields are unsigned.
/// Memory is written only where E is 1, but for enable_store.
// clang-format off
#define CSGSIM_OPCODES(OP)                                                                                             \
  OP(enable_all,        none,   none,     none,   one,          "E := 1")                                              \
  OP(enable_invert,     none,   none,     none,   one,          "E := not E")                                          \
  OP(enable_load,       source, none,     none,   one,          "E := s")                                              \
  OP(enable_and,        source, none,     none,   one,          "E := E and s")                                        \
  OP(enable_and_not,    source, none,     none,   one,          "E := E and not s")                                    \
  OP(enable_or,         source, none,     none,   one,          "E := E or s")                                         \
  OP(enable_xor,        source, none,     none,   one,          "E := E xor s")                                        \
  OP(enable_store,      target, none,     none,   one,          "t := E, at every pixel, enabled or not")              \
  OP(edge_not_negative, linear, none,     none,   linear_once,  "E := E and F >= 0")                                   \
  OP(edge_negative,     linear, none,     none,   linear_once,  "E := E and F < 0")                                    \
  OP(linear_ge,         source, linear,   none,   linear_once,  "E := E and F >= s")                                   \
  OP(linear_gt,         source, linear,   none,   linear_once,  "E := E and F > s")                                    \
  OP(linear_le,         source, linear,   none,   linear_once,  "E := E and F <= s")                                   \
  OP(linear_lt,         source, linear,   none,   linear_once,  "E := E and F < s")                                    \
  OP(linear_eq,         source, linear,   none,   linear_once,  "E := E and F = s")                                    \
  OP(load_linear,       target, linear,   none,   linear_once,                                                         \
     "where E: t := the low bits of F, and E := 0 if F does not fit t")                                            \
  OP(keep_max,          target, linear,   none,   linear_twice,                                                        \
     "where E and F > t: t := the low bits of F, and E := 0 if F does not fit t")                                  \
  OP(keep_min,          target, linear,   none,   linear_twice,                                                        \
     "where E and F < t: t := the low bits of F, and E := 0 if F does not fit t")                                  \
  OP(set_constant,      target, constant, none,   field,        "where E: t := k")                                     \
  OP(copy,              target, source,   none,   field,        "where E: t := s")                                     \
  OP(field_lt,          source, source,   none,   two_fields,   "E := E and s < r")                                    \
  OP(field_le,          source, source,   none,   two_fields,   "E := E and s <= r")                                   \
  OP(field_eq,          source, source,   none,   two_fields,   "E := E and s = r")                                    \
  OP(bit_and,           target, source,   source, two_fields,   "where E: t := s and r, bit by bit")                   \
  OP(bit_or,            target, source,   source, two_fields,   "where E: t := s or r, bit by bit")                    \
  OP(bit_xor,           target, source,   source, two_fields,   "where E: t := s xor r, bit by bit")                   \
  OP(bit_and_not,       target, source,   source, two_fields,   "where E: t := s and not r, bit by bit")               \
  OP(bit_not,           target, source,   none,   field,        "where E: t := not s, bit by bit")                     \
  OP(global_or,         none,   none,     none,   answer,       "the host is told whether E is 1 at any pixel")        \
  OP(xor_constant,      target, constant, none,   field,        "where E: t := t xor k, bit by bit")                    \
  OP(skip_if_none,      count,  none,     none,   answer,                                                              \
     "if E is 1 at no pixel, the next k instructions of the segment are not carried out")
// clang-format on

enum class Opcode : std::uint8_t {
#define CSGSIM_OPCODE_ENUMERATOR(name, ...) name,
  CSGSIM_OPCODES(CSGSIM_OPCODE_ENUMERATOR)
#undef CSGSIM_OPCODE_ENUMERATOR
};

inline constexpr std::size_t max_operands = 3;

/// One row of the table.
struct OpcodeInfo {
  Opcode opcode;
  std::string_view name;
  std::array<OperandKind, max_operands> operands;
  ClockClass clock_class;
  std::string_view meaning;
};

inline constexpr auto opcode_table = std::to_array<OpcodeInfo>({
#define CSGSIM_OPCODE_ROW(name, first, second, third, clocks, meaning)      \
  OpcodeInfo{Opcode::name,                                                  \
             #name,                                                         \
             {OperandKind::first, OperandKind::second, OperandKind::third}, \
             ClockClass::clocks,                                            \
             meaning},
    CSGSIM_OPCODES(CSGSIM_OPCODE_ROW)
#undef CSGSIM_OPCODE_ROW
});

constexpr const OpcodeInfo& info(Opcode opcode) { return opcode_table[static_cast<std::size_t>(opcode)]; }

}  // namespace csgsim::isa
