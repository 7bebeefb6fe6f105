// Blending of colours in pixel memory.
// Used by the effects.
#pragma once

#include "host/emit/broadcast.h"
#include "host/emit/fields.h"

namespace csgsim::effects {

/// Number of fraction bits of colour weights, which are in units of 1/256.
inline constexpr unsigned weight_bits = 8;
inline constexpr unsigned full_weight = 1U << weight_bits;

using emit::colour_channels;
using emit::subfield;

/// target += constant * source, where E is 1. The constant must be below `full_weight`.
void emit_multiply_add(emit::Broadcast& out, isa::Field target, unsigned constant, isa::Field source);

/// Where E is 1: colour := (weight * overlay + (256 - weight) * colour) / 256, rounded half up. `product` is a scratch
/// field of 16 bits.
void emit_blend(emit::Broadcast& out, isa::Field colour, isa::Field overlay, unsigned weight, isa::Field product);

}  // namespace csgsim::effects
