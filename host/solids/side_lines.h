// Canonical lines of a profile's sides.
// Used by bent_slices.cpp, linear_extrude.cpp and rotate_extrude.cpp.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/facet/planes.h"
#include "host/flat/area.h"

namespace csgsim::solids {

/// The area of an outline; negative for a hole, because a hole runs clockwise.
double signed_area(const flat::Outline& outline);

/// The lines of a profile's sides. Sides on a common line get the same numbers, even if the parts are on opposite sides
/// of the line.
class SideLines {
 public:
  explicit SideLines(const flat::Area& area);

  /// Returns (normal, offset) with normal . p + offset = 0 on the line. The normal has length 1 and points to the right
  /// of the direction from `a` to `b`.
  glm::dvec3 operator()(const glm::dvec2& a, const glm::dvec2& b);

 private:
  facet::PlaneTable planes_;
};

}  // namespace csgsim::solids
