// The linear functions that may be the greatest somewhere in a rectangle.
// Used by host/emit and sim/software.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/view/fixed_point.h"

namespace csgsim::view {

/// For each function, whether it may be the greatest somewhere in a rectangle of pixels. A function is excluded if
/// another one, which is the greatest at some corner, exceeds it by at least `step` at every corner, and hence at every
/// pixel. If `step` is 0, the first of equal functions is kept. If `comparisons` is not null, the number of corner
/// values compared is added to it.
std::vector<bool> leading(std::span<const FixedLinear> functions, const PixelRect& pixels, std::int64_t step,
                          std::uint64_t* comparisons = nullptr);

}  // namespace csgsim::view
