// Distances and the flatness test of surface elements.
// Used by net.cpp and sweep.cpp.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "host/swept/surface.h"

namespace csgsim::swept {

/// Distance of a point from the plane through three points; if these are collinear, from the line through the two
/// farthest apart.
double distance_to_plane(const glm::dvec3& point, const std::array<glm::dvec3, 3>& plane);

/// Distance of a point from a line segment.
double distance_to_segment(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to);

/// Operations in one call of distance_to_segment().
inline constexpr Arithmetic line_arithmetic{16, 12, 1, 0};

/// Whether an element is flat by the test of the thesis: its fourth corner and `middle` are within the tolerance, in
/// model units, of the plane through its south-west, south-east and north-west corners (our assumption, as the thesis
/// does not name them). If the south or west side is a point, the south-west corner takes the place of the fourth. Adds
/// the operations to the counts.
bool is_flat(const std::array<glm::dvec3, 4>& corners, const glm::dvec3& middle, double tolerance,
             SubdivisionCounts& counts);

}  // namespace csgsim::swept
