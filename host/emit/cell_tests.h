// Count of the cell tests with which the divider drops redundant half-spaces.
// Used by division_counts.
#pragma once

#include <cstdint>
#include <span>

#include "host/view/projection.h"

namespace csgsim::emit {

/// Number of cell tests of the divider for the half-spaces of one side over a rectangle of pixels
/// (docs/machines/pixel-square.md); a cell takes one test for each half-space left in it. `sign` is 1 for fronts and -1
/// for backs, `step` a whole depth step. With `quarters`, cells are subdivided until every half-space is known to be
/// kept or dropped; otherwise only the rectangle is tested.
std::uint64_t count_cell_tests(std::span<const view::FixedLinear> planes, std::int64_t sign, std::int64_t step,
                               const view::PixelRect& pixels, bool quarters);

}  // namespace csgsim::emit
