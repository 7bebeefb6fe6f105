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

bool takes_wide_field(Opcode opcode) {
  return info(opcode).widths == FieldWidths::wide || info(opcode).widths == FieldWidths::odd;
}

bool looks_ahead(Opcode opcode) { return opcode == Opcode::skip_if_none || opcode == Opcode::squares; }

bool cuts_sum(Opcode opcode) { return opcode == Opcode::stripe; }

}  // namespace csgsim::isa
