// Projection of points for exact 2D predicates.
// Used by crossings.cpp and triangulate.cpp.
#pragma once

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>
#include <utility>
#include <vector>

namespace csgsim::software::convert {

using ProjectionKernel = CGAL::Exact_predicates_inexact_constructions_kernel;

/// Projects points along the axis closest to a plane's outward normal, as seen from outside.
class PlaneProjection {
 public:
  PlaneProjection(const std::vector<glm::dvec3>& points, const glm::dvec3& outward) : points_(points) {
    int axis = 0;
    for (int other = 1; other < 3; ++other)
      if (std::abs(outward[other]) > std::abs(outward[axis])) axis = other;
    across_ = (axis + 1) % 3;
    up_ = (axis + 2) % 3;
    if (outward[axis] < 0) std::swap(across_, up_);
  }

  [[nodiscard]] ProjectionKernel::Point_2 operator()(std::uint32_t point) const {
    return {points_[point][across_], points_[point][up_]};
  }

 private:
  const std::vector<glm::dvec3>& points_;
  int across_ = 0;
  int up_ = 0;
};

}  // namespace csgsim::software::convert
