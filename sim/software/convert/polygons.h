#pragma once

#include <cstdint>
#include <vector>

#include "sim/software/convert/surface.h"

namespace csgsim::software::convert {

/// The faces of a surface, by its points: what hangs together in one plane is one polygon where it has no holes and its
/// corners are in a plane exactly, else its triangles.
std::vector<std::vector<std::uint32_t>> polygons_of(const Surface& surface);

}  // namespace csgsim::software::convert
