// Point sets with a support function.
// Used by separation tests.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"

namespace csgsim::csg {

/// Points with a support function: the farthest point along a direction. Keeps a reference to the points.
class Hull {
 public:
  explicit Hull(std::span<const glm::dvec3> points);

  [[nodiscard]] std::span<const glm::dvec3> points() const { return points_; }
  /// Minimum and maximum coordinates, if there are points.
  [[nodiscard]] const glm::dvec3& low() const { return box_.low; }
  [[nodiscard]] const glm::dvec3& high() const { return box_.high; }

  /// The first of the points (at least one) that are farthest along a direction.
  const glm::dvec3& support(const glm::dvec3& direction);

 private:
  void arrange();

  std::span<const glm::dvec3> points_;
  facet::Box box_;
  /// The coordinates of the points by axis, for vector loads; the last point is repeated up to a multiple of
  /// farthest_row. Built by the second query.
  std::array<std::vector<double>, 3> axes_;
  bool was_queried_ = false;
};

}  // namespace csgsim::csg
