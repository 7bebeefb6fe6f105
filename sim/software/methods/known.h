// Classes of primitives that are known before rays are cast, for pruning.
// Used by evaluations.h and by interval arithmetic.
#pragma once

#include <cstdint>
#include <vector>

#include "host/view/projection.h"
#include "sim/software/rays/ray_band.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Columns of a cell of the picture; a cell has the rows of a band.
inline constexpr std::uint32_t cell_columns = 16;

/// Marks primitives without pixels in `columns` columns of a band as outside.
std::vector<Known> classes_in_cell(const view::View& view, const RayBand& band, std::uint32_t first_column,
                                   std::uint32_t columns);

/// Marks the primitive itself as inside, and primitives that are separated from it in pixels or depth as outside.
std::vector<Known> classes_inside(const view::View& view, std::uint32_t primitive);

}  // namespace csgsim::software
