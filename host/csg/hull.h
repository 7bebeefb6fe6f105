#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"

namespace csgsim::csg {

/// Points whose farthest along a direction is asked for. Keeps a reference to the points.
class Hull {
 public:
  explicit Hull(std::span<const glm::dvec3> points);

  [[nodiscard]] std::span<const glm::dvec3> points() const { return points_; }
  /// The least and the greatest coordinates, if there are points.
  [[nodiscard]] const glm::dvec3& low() const { return box_.low; }
  [[nodiscard]] const glm::dvec3& high() const { return box_.high; }

  /// The first of the points, of which there are some, that are farthest along a direction.
  const glm::dvec3& support(const glm::dvec3& direction);

 private:
  void arrange();

  std::span<const glm::dvec3> points_;
  facet::Box box_;
  /// The coordinates of the points an axis after the other, for vectors of them; the last point again and again up to
  /// a whole number of rows. Made when they are asked for a second time.
  std::array<std::vector<double>, 3> axes_;
  bool was_asked_ = false;
};

}  // namespace csgsim::csg
