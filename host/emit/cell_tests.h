#pragma once

#include <cstdint>
#include <span>

#include "host/view/projection.h"

namespace csgsim::emit {

/// How many cell tests the divider makes of one side's half-spaces over a rectangle of pixels
/// (docs/machines/pixel-square.md), one a half-space that is left in each cell: `sign` is 1 for fronts and -1 for
/// backs, `step` a whole depth step. With `quarters`, until it is known of each half-space whether it stays; else in
/// the rectangle alone.
std::uint64_t count_cell_tests(std::span<const view::FixedLinear> planes, std::int64_t sign, std::int64_t step,
                               const view::PixelRect& pixels, bool quarters);

}  // namespace csgsim::emit
