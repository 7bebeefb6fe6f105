#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>

#include "host/swept/surface.h"

namespace csgsim::swept {

/// How far a point is off the plane of three; off the line through the two that are farthest apart, if they are on one.
double off_plane(const glm::dvec3& point, const std::array<glm::dvec3, 3>& plane);

/// How far a point is off the line from one to another, between its ends.
double off_line(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to);

/// What holding a point against a line takes.
inline constexpr Arithmetic line_arithmetic{16, 12, 1, 0};

/// The thesis's Flat: the plane is that of the south-west, south-east and north-west corners, assumed.
bool is_flat(const std::array<glm::dvec3, 4>& corners, const glm::dvec3& middle, double tolerance,
             SubdivisionCounts& counts);

}  // namespace csgsim::swept
