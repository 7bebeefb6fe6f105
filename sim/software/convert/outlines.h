// Outlines of the boundary in planes.
// Used by sim/software/convert.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "sim/software/convert/bodies.h"
#include "sim/software/convert/exact_outlines.h"
#include "sim/software/convert/side.h"

namespace csgsim::software::convert {

/// The part of the boundary in one plane with the solid on one side: its sides run counter-clockwise around it as seen
/// from outside, and clockwise around holes. A side may occur more than once.
struct Outline {
  glm::dvec3 outward{0};  ///< unit normal
  std::vector<Side> sides;
};

/// Outlines with shared points; every side is matched by an opposite side of the same or another outline.
struct Outlines {
  std::vector<glm::dvec3> points;  ///< in model space
  std::vector<Outline> outlines;
};

/// Rounds outlines that are closed on exact points: points closer to each other than the tolerance of the bodies are
/// merged, if possible into a corner of a primitive; sides are split at every point on them, and joined at points where
/// only collinear sides meet. Empty if coplanar faces of whole bodies cross. Throws std::logic_error if the result is
/// not closed.
std::optional<Outlines> join(const Bodies& bodies, ExactOutlines exact);

}  // namespace csgsim::software::convert
