#pragma once

#include "host/emit/context.h"
#include "host/view/screen_quadric.h"

namespace csgsim::emit {

/// Bits of the squares of a region's pixels: of x^2 + y^2, counted from the region's first pixel, less what of it is
/// linear and makes it greater than it has to be: (x - (w - 1) / 2)^2 + (y - (h - 1) / 2)^2, each square rounded so
/// that the least is 0.
unsigned squares_bits(const isa::Region& region);

/// Layout::squares := the squares, at every pixel of the segment. E is lost.
///
/// Bit by bit: x (x - w + 1) is the sum of 2^i (x - w + 1) over the bits i of x that are 1. Of n bits each of x and y,
/// and W of the squares, that is 2 n (W + 3) + W + 1 clocks: 378 at 512 x 512, once a picture.
void emit_squares(const Context& context, Broadcast& out);

/// E stays 1 in the circle of a paraboloid.
void emit_circle(const Context& context, Broadcast& out, const view::ScreenQuadric& sphere,
                 const view::PixelRect& pixels);

/// Where E is 1, which has to be 0 outside the circle: a depth of a paraboloid into `sum`, which holds it with as many
/// bits after the point as the factor has, as a two's complement number.
void emit_paraboloid(const Context& context, Broadcast& out, const view::ScreenQuadric& sphere, bool is_near,
                     isa::Field sum, const view::PixelRect& pixels);

}  // namespace csgsim::emit
