// Fast spheres: spheres as paraboloids, from squares that pixel memory holds.
// Used by quadric_depths and compile.cpp.
#pragma once

#include "host/emit/context.h"
#include "host/view/screen_quadric.h"

namespace csgsim::emit {

/// Bits of the squares of a region's pixels: (x - (w - 1) / 2)^2 + (y - (h - 1) / 2)^2 relative to the region's first
/// pixel, each square rounded so that its minimum is 0. That is x^2 + y^2 without the linear part that would make it
/// wider.
unsigned squares_bits(const isa::Region& region);

/// Writes the squares to Layout::squares at every pixel of the segment. E is lost.
///
/// It works bit by bit: x (x - w + 1) is the sum of 2^i (x - w + 1) over the bits i of x that are 1. With n bits each
/// for x and y, and W for the squares, that takes 2 n (W + 3) + W + 1 clocks: 378 at 512 x 512, once per picture.
void emit_squares(const Context& context, Broadcast& out);

/// E stays 1 in the circle that a paraboloid covers.
void emit_circle(const Context& context, Broadcast& out, const view::ScreenQuadric& sphere,
                 const view::PixelRect& pixels);

/// Writes a depth of a paraboloid to `sum` where E is 1, as a two's complement number with the fraction bits of the
/// factor. E must be 0 outside the circle.
void emit_paraboloid(const Context& context, Broadcast& out, const view::ScreenQuadric& sphere, bool is_near,
                     isa::Field sum, const view::PixelRect& pixels);

}  // namespace csgsim::emit
