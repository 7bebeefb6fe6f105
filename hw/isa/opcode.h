// Opcode numbers and their properties.
// Used by opcodes.h and instruction.h.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace csgsim::isa {

/// The number of an instruction. Names and properties are in the table, hw/isa/opcodes.h, which only files that name
/// instructions or read whole rows need to include.
enum class Opcode : std::uint8_t;

inline constexpr unsigned opcode_bits = 6;
inline constexpr std::size_t opcode_numbers = std::size_t{1} << opcode_bits;

/// Kinds of operands.
enum class OperandKind : std::uint8_t {
  none,
  target,    ///< a field of pixel memory that is written
  source,    ///< a field of pixel memory that is read
  linear,    ///< A, B, C, width, shift of a linear expression
  constant,  ///< an unsigned constant as wide as the target field
  count,     ///< a number of instructions, at least 1
  squares,   ///< A, B, C and width of the quadratic part of the next instruction's expression
};

inline constexpr std::size_t max_operands = 3;
using Operands = std::array<OperandKind, max_operands>;

/// Whether the opcode has a row in the table. A value from a file or a link may have none.
bool in_table(Opcode opcode);

std::string_view name_of(Opcode opcode);
const Operands& operands_of(Opcode opcode);

/// Whether the instruction needs the machine's global OR.
bool needs_global_or(Opcode opcode);

/// Whether the value written to the target depends on its previous value.
bool reads_target(Opcode opcode);

/// Whether the fields may have up to max_wide_field_width bits.
bool allows_wide_fields(Opcode opcode);

/// Whether the validity of the instruction depends on the instructions after it.
bool needs_lookahead(Opcode opcode);

/// Whether A*x + B*y + C may exceed the width by design; this is not counted as an overflow.
bool may_exceed_width(Opcode opcode);

}  // namespace csgsim::isa
