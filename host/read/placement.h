// Matrices and colours of nodes.
// Used by build.cpp and host/commands.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "host/read/arguments.h"

namespace csgsim::read {

/// The matrix of a `multmatrix` node, scaled so that its last row is 0 0 0 1. Not finite if an entry is not finite or
/// the last row is 0 0 0 0. A projective part is ignored with a warning, as in OpenSCAD.
glm::dmat4 read_matrix(const Arguments& arguments);

/// Whether the matrix leaves nothing of a solid, because it is singular or not finite.
bool empties(const glm::dmat4& matrix);

/// The colour of a `color` node, each component in [0, 1].
struct Colour {
  std::optional<glm::dvec3> rgb;  ///< none if a component is negative, which is how OpenSCAD writes an unset colour
  double opacity = 1;             ///< 1 if negative in the file
  bool is_whole = true;           ///< no component is negative; otherwise colours of nodes inside replace this one
};

Colour read_colour(const Arguments& arguments);

}  // namespace csgsim::read
