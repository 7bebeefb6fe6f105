#pragma once

#include <glm/vec2.hpp>

#include "host/flat/area.h"

namespace csgsim::flat::svg {

/// An elliptical arc of a path.
struct Arc {
  glm::dvec2 from{0};
  glm::dvec2 to{0};
  glm::dvec2 radii{0};  ///< enlarged where they are too small for the distance
  double turn = 0;      ///< of the ellipse, degrees
  bool large = false;   ///< the longer way
  bool sweep = false;   ///< in the direction of growing angles
};

/// Adds its corners to the outline: sides of at most 18 degrees, and four more. A line if a radius is 0, and nothing if
/// it ends where it begins.
void add_arc(Outline& outline, const Arc& arc);

}  // namespace csgsim::flat::svg
