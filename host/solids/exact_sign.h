// Exact signs of 3x3 determinants of point differences.
// Used by hull.cpp and hull_faces.cpp.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

namespace csgsim::solids {

/// The difference of two points, stored unevaluated.
struct Difference {
  glm::dvec3 to;
  glm::dvec3 from;
};

/// The exact sign of the determinant of three differences of points: -1, 0 or 1. Empty if coordinates are so large or
/// small (beyond 1e90, or below 1e-75 but not 0) that an intermediate result might leave the range of doubles.
std::optional<int> sign_of_determinant(const std::array<Difference, 3>& rows);

}  // namespace csgsim::solids
