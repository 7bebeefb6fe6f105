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
  glm::dvec2 radii{0};  ///< enlarged by add_arc() if too small for the distance between the ends
  double turn = 0;      ///< rotation of the ellipse, degrees
  bool large = false;   ///< whether the arc is the longer of the two possible arcs
  bool sweep = false;   ///< whether the arc runs in the direction of increasing angles
};

/// Adds the arc's corners to the outline: one side per 18 degrees (rounded up) plus four. Adds a line if a radius is 0,
/// and nothing if the ends coincide.
void add_arc(Outline& outline, const Arc& arc);

}  // namespace csgsim::flat::svg
