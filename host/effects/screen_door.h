// Screen-door patterns for transparency.
// Used by transparency.cpp and its test.
#pragma once

#include "host/emit/broadcast.h"

namespace csgsim::effects {

/// Number of pixels of each 4 x 4 block in the pattern of full density.
inline constexpr unsigned max_pattern_pixels = 16;

/// Leaves E at 1 at `pixels` pixels of each 4 x 4 block: those where M < pixels. The bits of M, highest first, are bit
/// 0 of x + y, bit 0 of y, bit 1 of x + y, bit 1 of y, where x and y are column and row of the picture. This is an
/// ordered dither: a pattern contains all sparser patterns. `spare` is one bit for saving E.
void emit_screen_door(emit::Broadcast& out, unsigned pixels, isa::Field spare);

}  // namespace csgsim::effects
