#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/solids/flat_outline.h"

namespace csgsim::solids {

/// The corners of a face as they are seen along the axis that it faces most, so that it runs counter-clockwise; at
/// least three.
std::vector<SeenPoint> seen(std::span<const glm::vec3> outline);

}  // namespace csgsim::solids
