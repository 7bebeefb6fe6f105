// Queries about operands of instructions.
// Used by hw and sim.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "hw/isa/program.h"

namespace csgsim::isa {

constexpr bool is_field(OperandKind kind) { return kind == OperandKind::target || kind == OperandKind::source; }

constexpr bool has_operand(const Operands& operands, OperandKind kind) {
  return std::find(operands.begin(), operands.end(), kind) != operands.end();
}

/// Whether the instruction may write to bits of the field.
inline bool may_write(const Instruction& instruction, Field field) {
  const Operands& operands = operands_of(instruction.opcode);
  for (std::size_t i = 0; i < max_operands; ++i)
    if (operands[i] == OperandKind::target && instruction.fields[i].overlaps(field)) return true;
  return false;
}

/// The number of instructions that `instruction` skips if `enabled_pixels` pixels are enabled.
inline std::uint64_t skipped_instruction_count(const Instruction& instruction, std::uint64_t enabled_pixels) {
  return enabled_pixels == 0 && has_operand(operands_of(instruction.opcode), OperandKind::count) ? instruction.constant
                                                                                                 : 0;
}

/// The `squares` instruction directly before instruction `index` of the segment, if any. A run that begins at `index`
/// has to execute the squares first.
inline const Instruction* pending_squares(const Segment& segment, std::size_t index) {
  if (index == 0) return nullptr;
  const Instruction& before = segment.instructions[index - 1];
  return has_operand(operands_of(before.opcode), OperandKind::squares) ? &before : nullptr;
}

/// Whether the purpose has a row in the table. A value from a file may have none.
constexpr bool in_table(Purpose purpose) { return static_cast<std::size_t>(purpose) < purpose_table.size(); }

}  // namespace csgsim::isa
