#pragma once

#include <array>

#include "host/emit/broadcast.h"

namespace csgsim::effects {

/// Parts of a colour are in 1/256.
inline constexpr unsigned part_bits = 8;
inline constexpr unsigned whole = 1U << part_bits;

/// So many bits of a field, from that one on.
isa::Field part_of(isa::Field field, unsigned from, unsigned width);

/// Red, green and blue of a colour field.
std::array<isa::Field, 3> channels_of(isa::Field colour);

/// Where E: target += constant * source, with a constant below `whole`.
void add_times(emit::Broadcast& out, isa::Field target, unsigned constant, isa::Field source);

/// Where E: colour := part / 256 of `over` and the rest of itself, rounded, halves up. `product` is 16 bits of scratch.
void emit_blend(emit::Broadcast& out, isa::Field colour, isa::Field over, unsigned part, isa::Field product);

}  // namespace csgsim::effects
