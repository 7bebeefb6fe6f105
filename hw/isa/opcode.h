#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace csgsim::isa {

/// An instruction by its number. The names and all that holds of each stand in the table, hw/isa/opcodes.h; only what
/// names instructions or reads whole rows needs it.
enum class Opcode : std::uint8_t;

inline constexpr unsigned opcode_bits = 6;
inline constexpr std::size_t opcode_numbers = std::size_t{1} << opcode_bits;

/// What an operand of an instruction is.
enum class OperandKind : std::uint8_t {
  none,
  target,    ///< a field of pixel memory that is written
  source,    ///< a field of pixel memory that is read
  linear,    ///< A, B, C, width, shift of a linear expression
  constant,  ///< an unsigned constant as wide as the target field
  count,     ///< a number of instructions, 1 at least
  squares,   ///< A, B, C, width of what the next instruction's linear expression has besides
};

inline constexpr std::size_t max_operands = 3;
using Operands = std::array<OperandKind, max_operands>;

/// Is there a row for it? A value read from a file or a link need not have one.
bool in_table(Opcode opcode);

std::string_view name_of(Opcode opcode);
const Operands& operands_of(Opcode opcode);

/// Does it need the global OR of the machine?
bool is_question(Opcode opcode);

/// Does what it writes to its target depend on what is there?
bool reads_target(Opcode opcode);

/// May its field have up to max_wide_field_width bits?
bool takes_wide_field(Opcode opcode);

/// Does the validity of an instruction depend on those that follow it?
bool looks_ahead(Opcode opcode);

/// Is A*x + B*y + C meant to have more bits than the width, so that it is no overflow where it has?
bool cuts_sum(Opcode opcode);

}  // namespace csgsim::isa
