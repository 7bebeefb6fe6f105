// Elliptical arcs of SVG paths.
// Used by path.cpp.
#pragma once

#include <glm/vec2.hpp>

#include "host/flat/area.h"

namespace csgsim::flat::svg {

/// An elliptical arc of a path.
struct Arc {
  glm::dvec2 from{0};
  glm::dvec2 to{0};
  glm::dvec2 radii{0};  ///< enlarged if too small for the distance between the ends
  double turn = 0;      ///< rotation of the ellipse, degrees
  bool large = false;   ///< take the longer way
  bool sweep = false;   ///< the arc runs in the direction of increasing angles
};

/// Adds the arc's corners to the outline: sides of at most 18 degrees, plus four. Adds a line if a radius is 0, and
/// nothing if the ends coincide.
void add_arc(Outline& outline, const Arc& arc);

}  // namespace csgsim::flat::svg
