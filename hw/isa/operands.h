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

/// May it write to the field?
inline bool may_write(const Instruction& instruction, Field field) {
  const Operands& operands = operands_of(instruction.opcode);
  for (std::size_t i = 0; i < max_operands; ++i)
    if (operands[i] == OperandKind::target && instruction.fields[i].overlaps(field)) return true;
  return false;
}

/// Instructions after this one that are not carried out, if so many pixels are enabled.
inline std::uint64_t skipped_after(const Instruction& instruction, std::uint64_t enabled_pixels) {
  return enabled_pixels == 0 && has_operand(operands_of(instruction.opcode), OperandKind::count) ? instruction.constant
                                                                                                 : 0;
}

/// The squares right before the instruction of that number in its segment, if there are any: a run that begins with
/// that instruction has to carry them out first.
inline const Instruction* pending_squares(const Segment& segment, std::size_t index) {
  if (index == 0) return nullptr;
  const Instruction& before = segment.instructions[index - 1];
  return has_operand(operands_of(before.opcode), OperandKind::squares) ? &before : nullptr;
}

/// Is there a row for it? A value read from a file need not have one.
constexpr bool in_table(Purpose purpose) { return static_cast<std::size_t>(purpose) < purpose_table.size(); }

}  // namespace csgsim::isa
