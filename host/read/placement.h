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

/// The colour of a `color` node, in [0, 1]; nothing if it has a negative component, which is how OpenSCAD writes that
/// none is given.
std::optional<glm::dvec3> read_colour(const Arguments& arguments);

}  // namespace csgsim::read
