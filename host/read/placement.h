// Matrices and colours of nodes.
// Used by build.h, build.cpp and host/commands.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "host/read/arguments.h"

namespace csgsim::read {

/// The matrix of a `multmatrix` node, scaled so that its last row is 0 0 0 1. The result is not finite if an entry is
/// not finite or the last row is 0 0 0 0. A projective part is ignored with a warning, as in OpenSCAD.
glm::dmat4 read_matrix(const Arguments& arguments);

/// Whether a transformation by the matrix makes every solid empty: it is singular or not finite.
bool is_degenerate(const glm::dmat4& matrix);

/// The colour of a `color` node, each component in [0, 1].
struct Colour {
  std::optional<glm::dvec3> rgb;  ///< empty if a component is negative, which is how OpenSCAD writes an unset colour
  double opacity = 1;             ///< alpha; 1 if it is negative in the file
  /// Whether no component is negative; if false, colours of inner nodes replace this colour.
  bool is_whole = true;
};

Colour read_colour(const Arguments& arguments);

}  // namespace csgsim::read
