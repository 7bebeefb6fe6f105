#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "host/flat/area.h"

namespace csgsim::flat {

/// The area under the x, y part of the matrix, whose last row is 0 0 0 1: what its third row and column say is left
/// out. Empty if that part is singular. Throws InputError if a corner is not finite then.
Area transformed(const Area& area, const glm::dmat4& matrix);

/// Scaled about the origin to the size where it is above 0. Where it is not, by 1; or, if `automatic`, as the larger
/// component of the size scales its own direction.
Area resized(const Area& area, const glm::dvec2& size, const glm::bvec2& automatic);

}  // namespace csgsim::flat
