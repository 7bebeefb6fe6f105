#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::view {

/// Which functions may be the greatest one somewhere in a rectangle of pixels: all but those that another, greatest at
/// a corner, is above by `step` at least, at every corner and so at every pixel between. With a step of 0, of functions
/// that are alike the first stays.
std::vector<bool> leading(std::span<const FixedLinear> functions, const PixelRect& pixels, std::int64_t step);

}  // namespace csgsim::view
