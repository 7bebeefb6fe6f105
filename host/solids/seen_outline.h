// Projection of a face's outline, as in libtess2.
// Used by tessellation.cpp.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/solids/flat_outline.h"

namespace csgsim::solids {

/// Projects the corners of a face along the dominant axis of its normal, so that the result runs counter-clockwise.
/// There must be at least three corners.
std::vector<ProjectedPoint> project_outline(std::span<const glm::vec3> outline);

}  // namespace csgsim::solids
