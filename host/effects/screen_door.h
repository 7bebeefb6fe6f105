#pragma once

#include "host/emit/broadcast.h"

namespace csgsim::effects {

/// Pixels of every 4 x 4 that the pattern of full density has.
inline constexpr unsigned most_pixels = 16;

/// E stays 1 at so many pixels of every 4 x 4: those where M < pixels, M being the number of the bits, the highest
/// first, bit 0 of x + y, bit 0 of y, bit 1 of x + y, bit 1 of y; x and y are column and row of the picture. An ordered
/// dither: a pattern holds all that are sparser. `spare` is one bit to keep E in.
void emit_screen_door(emit::Broadcast& out, unsigned pixels, isa::Field spare);

}  // namespace csgsim::effects
