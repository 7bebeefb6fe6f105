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

/// All of the boundary that is in one plane and has the solid on one side of it: its sides run counter-clockwise around
/// it as seen from outside, clockwise around holes. A side may stand there more than once.
struct Outline {
  glm::dvec3 outward{0};  ///< of length 1
  std::vector<Side> sides;
};

/// Outlines that share points; wherever a side runs, as many run back, of other outlines or the same.
struct Outlines {
  std::vector<glm::dvec3> points;  ///< model space
  std::vector<Outline> outlines;
};

/// Rounds outlines that are closed on exact points: points nearer to each other than the tolerance of the bodies become
/// one, a corner of a primitive where there is one; sides end at every point that is on them, and go on through points
/// where nothing but straight sides meet. None if faces of whole bodies in one plane cross. Throws std::logic_error if
/// the outcome is not closed.
std::optional<Outlines> join(const Bodies& bodies, ExactOutlines exact);

}  // namespace csgsim::software::convert
