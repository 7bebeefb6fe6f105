// The farthest point along a direction, vectorized.
// Used by hull.cpp.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

namespace csgsim::csg {

/// Number of points processed together; the lengths of coordinate lists are multiples of it.
inline constexpr std::size_t farthest_row = 8;

/// Index of the first of the points that are farthest along a direction; the number of points if none is found, because
/// a value is NaN or the processor has no vectors of doubles. `axes`: the points' coordinates, one list per axis.
std::size_t first_farthest(const std::array<std::span<const double>, 3>& axes, const glm::dvec3& direction);

}  // namespace csgsim::csg
