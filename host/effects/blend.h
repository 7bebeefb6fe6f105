#pragma once

#include "host/emit/broadcast.h"
#include "host/emit/fields.h"

namespace csgsim::effects {

/// Parts of a colour are in 1/256.
inline constexpr unsigned part_bits = 8;
inline constexpr unsigned whole = 1U << part_bits;

using emit::channels_of;
using emit::part_of;

/// Where E: target += constant * source, with a constant below `whole`.
void add_times(emit::Broadcast& out, isa::Field target, unsigned constant, isa::Field source);

/// Where E: colour := part / 256 of `over` and the rest of itself, rounded, halves up. `product` is 16 bits of scratch.
void emit_blend(emit::Broadcast& out, isa::Field colour, isa::Field over, unsigned part, isa::Field product);

}  // namespace csgsim::effects
