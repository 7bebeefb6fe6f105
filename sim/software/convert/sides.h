// Splitting and joining of sides.
// Used by outlines.cpp, crossings.cpp and polygons.cpp.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "sim/software/convert/near_points.h"
#include "sim/software/convert/outlines.h"

namespace csgsim::software::convert {

/// Splits the sides of the outlines with these ascending indices at each point within the tolerance, in model units.
/// Returns the indices of the outlines that changed.
std::vector<std::size_t> split_at_points(std::span<const std::size_t> outline_indices, const NearPoints& near,
                                         double tolerance, Outlines& outlines);

/// Joins sides at points with only two neighbours that are collinear with the point.
void join_straight(Outlines& outlines, double tolerance);

/// A side without a matching opposite side in any outline, if any.
std::optional<Side> open_side(const Outlines& outlines);

}  // namespace csgsim::software::convert
