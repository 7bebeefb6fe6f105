#pragma once

#include <glm/geometric.hpp>

#include "host/facet/solid.h"

namespace csgsim::solids {

/// How far a point is in front of a plane; below 0 behind it.
inline double height(const facet::Plane& plane, const glm::dvec3& point) {
  return glm::dot(plane.normal, point) + plane.offset;
}

}  // namespace csgsim::solids
