#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "host/swept/curve.h"

namespace csgsim::swept {

/// Axes of a contour's plane, not yet turned and scaled; orthogonal and of length 1, but for mitres.
struct Plane {
  glm::dvec3 u{0};
  glm::dvec3 v{0};
};

/// A trajectory. A place of it is k + t on its segment k.
struct Path {
  std::vector<Segment> segments;
  bool is_closed = false;
  bool has_corners = false;  ///< of degree 1

  /// Directions of length 1 that a segment leaves its start in and comes to its end in. Throws InputError for one whose
  /// coefficients are all the same point.
  [[nodiscard]] glm::dvec3 leaving(std::size_t segment) const;
  [[nodiscard]] glm::dvec3 arriving(std::size_t segment) const;

  /// Of length 1; at a joint, half-way between the two that meet there. Throws InputError where these are opposite.
  [[nodiscard]] glm::dvec3 tangent(double place) const;
};

/// Which way the contour's v axis points: along the projection of the y axis on the contour's plane. Within some
/// degrees of that axis the contour is turned evenly, by the parameter, from where it is before to where it is behind.
class Orientation {
 public:
  explicit Orientation(const Path& path);

  /// The direction of v at a place, where the tangent is known.
  [[nodiscard]] glm::dvec3 upward(double place, const glm::dvec3& tangent) const;

 private:
  /// A stretch of the trajectory along the y axis, between two places.
  struct Gap {
    double from = 0;
    double to = 0;
    glm::dvec3 tangent{0};  ///< at the side that the contour is carried along from
    glm::dvec3 v{0};
    double turn = 0;  ///< radians about the tangent: by how much it is turned at the end of the gap
  };

  void add_gap(const Path& path, double before, double first, double last, double behind);
  [[nodiscard]] static double edge(const Path& path, double upright, double along);

  std::vector<Gap> gaps_;
  double length_ = 0;  ///< of a closed path, its segments; else 0
};

}  // namespace csgsim::swept
