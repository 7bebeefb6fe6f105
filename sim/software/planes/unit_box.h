// Boxes in units of the model.
// Used by sheets and by mesh conversion.
#pragma once

#include <glm/vec3.hpp>

namespace csgsim::software {

/// Upper bound of the rounding error of a position, or of its height above a plane, in units (WholePlanes).
inline constexpr double place_error = 1e-13;

/// A box in units, relative to the middle of the model; empty if a low exceeds its high.
struct UnitBox {
  glm::dvec3 low{1};
  glm::dvec3 high{0};

  [[nodiscard]] bool empty() const { return low.x > high.x; }
};

/// Whether the boxes are disjoint.
inline bool are_apart(const UnitBox& one, const UnitBox& other) {
  for (int axis = 0; axis < 3; ++axis)
    if (one.low[axis] > other.high[axis] || one.high[axis] < other.low[axis]) return true;
  return false;
}

}  // namespace csgsim::software
