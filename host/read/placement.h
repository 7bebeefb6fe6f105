#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <optional>

#include "host/read/arguments.h"

namespace csgsim::read {

/// The matrix of a `multmatrix` node, scaled so that its last row is 0 0 0 1. Not finite if an entry is not or if the
/// last row is 0 0 0 0. Throws InputError if it is projective.
glm::dmat4 read_matrix(const Arguments& arguments);

/// Whether nothing solid is left of a solid under the matrix: it is singular or not finite.
bool empties(const glm::dmat4& matrix);

/// What a `color` node says, each in [0, 1].
struct Colour {
  glm::dvec3 rgb{0};
  double opacity = 1;
};

/// Nothing if the node has a negative component, which is how OpenSCAD writes that no colour is given.
std::optional<Colour> read_colour(const Arguments& arguments);

}  // namespace csgsim::read
