// Transformation and resizing of 2-D areas.
// Used by host/read.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "host/flat/area.h"

namespace csgsim::flat {

/// Transforms an area by the x, y part of a matrix whose last row is 0 0 0 1; the third row and column are ignored.
/// Empty if the x, y part is singular. Throws InputError if a resulting corner is not finite.
Area transformed(const Area& area, const glm::dmat4& matrix);

/// Scales an area about the origin to `size`. An axis whose size is not above 0 keeps its scale or, if `automatic` is
/// set for it, is scaled by the factor of the axis with the larger size.
Area resized(const Area& area, const glm::dvec2& size, const glm::bvec2& automatic);

}  // namespace csgsim::flat
