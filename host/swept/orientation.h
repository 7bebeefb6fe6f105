// Trajectories, and the orientation of the contour along them.
// Used by spine.h.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <vector>

#include "host/swept/curve.h"

namespace csgsim::swept {

/// Axes of a contour's plane before rotation and scaling: orthogonal and of length 1, except at mitres.
struct Plane {
  glm::dvec3 u{0};
  glm::dvec3 v{0};
};

/// A trajectory. The position k + t is at the parameter t of segment k.
struct Path {
  std::vector<Segment> segments;
  bool is_closed = false;
  bool has_corners = false;  ///< whether it has degree 1

  /// Unit directions of a segment at its start and at its end. Throws InputError for a segment whose coefficients all
  /// coincide.
  [[nodiscard]] glm::dvec3 leaving(std::size_t segment) const;
  [[nodiscard]] glm::dvec3 arriving(std::size_t segment) const;

  /// Unit tangent; at a joint, the bisector of the two directions. Throws InputError if these are opposite.
  [[nodiscard]] glm::dvec3 tangent(double position) const;
};

/// Direction of the contour's v axis: along the projection of the y axis onto the contour's plane. In a gap where the
/// trajectory is within some degrees of the y axis, the contour turns linearly in the parameter between its directions
/// before and after the gap.
class Orientation {
 public:
  explicit Orientation(const Path& path);

  /// The direction of v at a position with the given tangent.
  [[nodiscard]] glm::dvec3 upward(double position, const glm::dvec3& tangent) const;

 private:
  /// An interval of the trajectory that runs along the y axis.
  struct Gap {
    double from = 0;
    double to = 0;
    glm::dvec3 tangent{0};  ///< tangent at the end of the gap from which the direction is continued
    glm::dvec3 v{0};
    double turn = 0;  ///< rotation about the tangent over the whole gap, in radians
  };

  /// Adds a gap, given the first and last sampled position in it and the sampled positions before and after it, which
  /// are `nowhere` if there are none.
  void add_gap(const Path& path, double upright_before, double first_along, double last_along, double upright_after);
  [[nodiscard]] static double find_gap_boundary(const Path& path, double upright, double along);

  std::vector<Gap> gaps_;
  double length_ = 0;  ///< number of segments of a closed path; otherwise 0
};

}  // namespace csgsim::swept
