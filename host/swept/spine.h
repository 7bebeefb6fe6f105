#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/swept/orientation.h"
#include "host/swept/sweep.h"

namespace csgsim::swept {

/// Where the contour is at a place of the trajectory, turned and scaled.
struct Section {
  glm::dvec3 origin{0};
  glm::dvec3 u{0};
  glm::dvec3 v{0};

  [[nodiscard]] glm::dvec3 at(const glm::dvec3& contour) const { return origin + contour.x * u + contour.y * v; }
  /// Of no size: the contour is a point there.
  [[nodiscard]] bool is_point() const { return u == glm::dvec3(0) && v == glm::dvec3(0); }
};

/// The trajectory and the sections along it. Corners of trajectories of degree 1 are mitred: there the plane halves the
/// angle, the contour is as much longer as keeps what is swept as thick, and between two corners sections turn and lean
/// evenly from one to the other.
class Spine {
 public:
  /// Of a sweep without fault. Throws InputError for a trajectory that has no direction somewhere, or a corner that
  /// cannot be mitred, and for turns and scales that do not close where the trajectory does.
  explicit Spine(const Sweep& sweep);

  [[nodiscard]] const std::vector<Segment>& segments() const { return path_.segments; }
  [[nodiscard]] bool is_closed() const { return path_.is_closed; }

  /// Between the ends of a segment, at t, given where the trajectory is there.
  [[nodiscard]] Section section(std::size_t segment, double t, const glm::dvec3& origin) const;
  /// At the start of a segment, or behind the last one.
  [[nodiscard]] const Section& joint(std::size_t number) const { return joints_[number]; }

  /// Whether a part of a segment is so short that its ends and its middle tell how it is turned and scaled: by a right
  /// angle at most, and by no more than a piece of each function.
  [[nodiscard]] bool is_short(std::size_t segment, double from, double to) const;

  /// The part of the trajectory's length, 0 to 1, up to there.
  [[nodiscard]] double part_of_length(std::size_t segment, double t) const;

 private:
  [[nodiscard]] Plane joint_plane(std::size_t number) const;
  [[nodiscard]] Section placed(const glm::dvec3& origin, const Plane& plane, double part) const;
  void measure();

  Path path_;
  Orientation orientation_;
  std::vector<Segment> rotation_;
  std::vector<Segment> scale_;
  std::vector<double> lengths_;  ///< up to each joint
  std::vector<Plane> planes_;    ///< of the joints
  std::vector<Section> joints_;
};

}  // namespace csgsim::swept
