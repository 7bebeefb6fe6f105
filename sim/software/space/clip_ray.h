// Clipping of rays against boxes.
// Used by all directories.
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>

#include "host/facet/geometry.h"
#include "sim/software/space/arithmetic.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// A section of a ray from `begin` to `end`; empty if begin > end.
struct RayPart {
  double begin = 0;
  double end = 0;

  [[nodiscard]] bool empty() const { return begin > end; }
};

/// The section of a ray in a closed box (Kay and Kajiya 1986).
template <class Count>
RayPart clip_to_box(const SpaceRay& ray, const glm::dvec3& inverse, const facet::Box& box, Count& count) {
  RayPart part{ray.begin, ray.end};
  for (int axis = 0; axis < 3 && !part.empty(); ++axis) {
    count(Operation::load_long, 3);
    count(Operation::branch);
    if (ray.direction[axis] == 0) {
      count_comparisons(count, 2);
      if (ray.origin[axis] < box.low[axis] || ray.origin[axis] > box.high[axis]) part = {1, 0};
      continue;
    }
    double near = (box.low[axis] - ray.origin[axis]) * inverse[axis];
    double far = (box.high[axis] - ray.origin[axis]) * inverse[axis];
    if (near > far) std::swap(near, far);
    count(Operation::add_long, 2);
    count_products(count, 2);
    count_comparisons(count, 3);
    part = {std::max(part.begin, near), std::min(part.end, far)};
  }
  return part;
}

/// Reciprocals of the direction's components.
template <class Count>
glm::dvec3 inverse_direction(const SpaceRay& ray, Count& count) {
  count_quotients(count, 3);
  return 1.0 / ray.direction;
}

}  // namespace csgsim::software
