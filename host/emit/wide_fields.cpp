#include "host/emit/wide_fields.h"

#include <algorithm>

#include "host/emit/fields.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

using isa::Opcode;

void emit_constant(Broadcast& out, isa::Field field, std::uint64_t constant) {
  for (unsigned first = 0; first < field.width; first += isa::max_field_width) {
    const unsigned width = std::min<unsigned>(field.width - first, isa::max_field_width);
    out.plain(Opcode::set_constant, part_of(field, first, width), {},
              constant >> first & ((std::uint64_t{1} << width) - 1));
  }
}

void emit_shifted(Broadcast& out, isa::Field source, isa::Field target, unsigned up) {
  const unsigned low = std::min<unsigned>(up, target.width);
  const unsigned width = std::min<unsigned>(source.width, target.width - low);
  emit_constant(out, part_of(target, 0, low), 0);
  const isa::Field to = part_of(target, low, width);
  const isa::Field from = part_of(source, 0, width);
  if (width > 0 && to != from) out.plain(Opcode::copy, to, from);
  emit_constant(out, part_of(target, low + width, target.width - low - width), 0);
}

}  // namespace csgsim::emit
