#include "host/csg/hull.h"

#include <cstddef>
#include <glm/geometric.hpp>

#include "host/csg/farthest.h"

namespace csgsim::csg {

namespace {

/// Up to this number, points are scanned linearly.
constexpr std::size_t few_points = 12;

const glm::dvec3& farthest_by_one(std::span<const glm::dvec3> points, const glm::dvec3& direction) {
  std::size_t best = 0;
  double most = glm::dot(points[0], direction);
  for (std::size_t i = 1; i < points.size(); ++i) {
    const double along = glm::dot(points[i], direction);
    if (!(most < along)) continue;
    most = along;
    best = i;
  }
  return points[best];
}

}  // namespace

Hull::Hull(std::span<const glm::dvec3> points) : points_(points), box_(facet::box_of(points)) {}

void Hull::arrange() {
  const std::size_t size = (points_.size() + farthest_row - 1) / farthest_row * farthest_row;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& values = axes_[static_cast<std::size_t>(axis)];
    values.reserve(size);
    for (const glm::dvec3& point : points_) values.push_back(point[axis]);
    values.resize(size, points_.back()[axis]);
  }
}

const glm::dvec3& Hull::support(const glm::dvec3& direction) {
  if (points_.size() <= few_points || !was_queried_) {
    was_queried_ = true;
    return farthest_by_one(points_, direction);
  }
  if (axes_[0].empty()) arrange();
  const std::size_t found = csg::first_farthest({axes_[0], axes_[1], axes_[2]}, direction);
  if (found < points_.size()) return points_[found];
  // A value is NaN, or there are no vectors of doubles.
  return farthest_by_one(points_, direction);
}

}  // namespace csgsim::csg
