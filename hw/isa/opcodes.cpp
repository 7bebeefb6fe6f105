#include "hw/isa/opcodes.h"

namespace csgsim::isa {

bool in_table(Opcode opcode) {
  const auto number = static_cast<std::size_t>(opcode);
  return number < opcode_numbers && opcode_rows[number] < opcode_table.size();
}

std::string_view name_of(Opcode opcode) { return info(opcode).name; }

const Operands& operands_of(Opcode opcode) { return info(opcode).operands; }

bool needs_global_or(Opcode opcode) { return info(opcode).clock_class == ClockClass::answer; }

bool reads_target(Opcode opcode) {
  return opcode == Opcode::keep_max || opcode == Opcode::keep_min || opcode == Opcode::xor_constant ||
         opcode == Opcode::add || opcode == Opcode::linear_plus || opcode == Opcode::linear_minus ||
         opcode == Opcode::root;
}

bool allows_wide_fields(Opcode opcode) {
  return info(opcode).widths == FieldWidths::wide || info(opcode).widths == FieldWidths::odd;
}

bool needs_lookahead(Opcode opcode) { return opcode == Opcode::skip_if_none || opcode == Opcode::squares; }

bool may_exceed_width(Opcode opcode) { return opcode == Opcode::stripe; }

}  // namespace csgsim::isa
