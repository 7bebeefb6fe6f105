// Polygons of surfaces.
// Used by file formats with polygons.
#pragma once

#include <cstdint>
#include <vector>

#include "sim/software/convert/surface.h"

namespace csgsim::software::convert {

/// The faces of a surface as lists of point indices: a connected part in one plane is one polygon if it has no holes
/// and its corners are exactly coplanar, and otherwise is divided into triangles.
std::vector<std::vector<std::uint32_t>> polygons_of(const Surface& surface);

}  // namespace csgsim::software::convert
