#include "host/effects/blend.h"

#include <array>

#include "hw/isa/opcodes.h"

namespace csgsim::effects {

using isa::Field;
using isa::Opcode;

void emit_multiply_add(emit::Broadcast& out, Field target, unsigned constant, Field source) {
  for (unsigned i = 0; i < weight_bits; ++i)
    if (((constant >> i) & 1U) != 0) out.plain(Opcode::add, subfield(target, i, target.width - i), source);
}

void emit_blend(emit::Broadcast& out, Field colour, Field overlay, unsigned weight, Field product) {
  if (weight == full_weight) {
    out.plain(Opcode::copy, colour, overlay);
    return;
  }
  const std::array<Field, 3> channels = colour_channels(colour);
  const std::array<Field, 3> over_channels = colour_channels(overlay);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const Field sum = subfield(product, 0, channels.at(i).width + weight_bits);
    out.plain(Opcode::set_constant, sum, {}, full_weight / 2);
    emit_multiply_add(out, sum, weight, over_channels.at(i));
    emit_multiply_add(out, sum, full_weight - weight, channels.at(i));
    out.plain(Opcode::copy, channels.at(i), subfield(sum, weight_bits, channels.at(i).width));
  }
}

}  // namespace csgsim::effects
