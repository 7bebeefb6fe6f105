#pragma once

#include <cstdint>
#include <vector>

#include "host/view/projection.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Columns of a cell of the picture; it has the rows of a band.
inline constexpr std::uint32_t cell_columns = 16;

/// Which primitives have no pixels in so many columns of a band.
std::vector<Known> known_in(const view::View& view, const RayBand& band, std::uint32_t first_column,
                            std::uint32_t columns);

/// Within a primitive it is in, and out are those that do not meet it: their pixels or their depths are apart.
std::vector<Known> known_inside(const view::View& view, std::uint32_t primitive);

}  // namespace csgsim::software
