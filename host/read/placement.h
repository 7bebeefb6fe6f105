#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "host/read/arguments.h"

namespace csgsim::read {

/// The matrix of a `multmatrix` node, scaled so that its last row is 0 0 0 1. Not finite if an entry is not or if the
/// last row is 0 0 0 0. A projection is left out, as OpenSCAD does, with a warning.
glm::dmat4 read_matrix(const Arguments& arguments);

/// Whether nothing solid is left of a solid under the matrix: it is singular or not finite.
bool empties(const glm::dmat4& matrix);

/// What a `color` node says, each in [0, 1].
struct Colour {
  std::optional<glm::dvec3> rgb;  ///< none where one is negative, which is how OpenSCAD writes that none is given
  double opacity = 1;             ///< also where it is negative
  bool is_whole = true;           ///< none is negative; else colours within say what they say, in place of all of it
};

Colour read_colour(const Arguments& arguments);

}  // namespace csgsim::read
