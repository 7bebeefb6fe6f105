#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <optional>

namespace csgsim::solids {

/// The difference of two points, not yet worked out.
struct Difference {
  glm::dvec3 to;
  glm::dvec3 from;
};

/// The sign of the determinant of three differences of points: -1, 0 or 1, exactly. None where coordinates are so
/// large or small (beyond 1e90, or other than 0 and below 1e-75) that a step of the sum might leave what doubles hold.
std::optional<int> sign_of_determinant(const std::array<Difference, 3>& rows);

}  // namespace csgsim::solids
