#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::view {

/// Which functions may be the greatest one somewhere in a rectangle of pixels: all but those that another, greatest at
/// a corner, is above by `step` at least, at every corner and so at every pixel between. With a step of 0, of functions
/// that are alike the first stays. The number of values at corners that are held against others is added to `held`.
std::vector<bool> leading(std::span<const FixedLinear> functions, const PixelRect& pixels, std::int64_t step,
                          std::uint64_t* held = nullptr);

}  // namespace csgsim::view
