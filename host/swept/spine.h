// Sections along a trajectory.
// Used by mesh.cpp and sweep.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/swept/orientation.h"
#include "host/swept/sweep.h"

namespace csgsim::swept {

/// The plane of the contour at a position of the trajectory, with rotation and scale applied.
struct Section {
  glm::dvec3 origin{0};
  glm::dvec3 u{0};
  glm::dvec3 v{0};

  [[nodiscard]] glm::dvec3 at(const glm::dvec3& contour) const { return origin + contour.x * u + contour.y * v; }
  /// Whether the contour collapses to a point.
  [[nodiscard]] bool is_point() const { return u == glm::dvec3(0) && v == glm::dvec3(0); }
};

/// The trajectory and the sections along it. Corners of trajectories of degree 1 are mitred: the section's plane
/// bisects the angle, and the contour is stretched so that the swept thickness is kept. Between two corners, sections
/// rotate and tilt linearly.
class Spine {
 public:
  /// The sweep must be valid. Throws InputError for a trajectory without a direction at some point, for a corner that
  /// cannot be mitred, and for rotations and scales that do not match where the trajectory closes.
  explicit Spine(const Sweep& sweep);

  [[nodiscard]] const std::vector<Segment>& segments() const { return path_.segments; }
  [[nodiscard]] bool is_closed() const { return path_.is_closed; }

  /// The section inside a segment, at the parameter t; `origin` is the trajectory's point there.
  [[nodiscard]] Section section(std::size_t segment, double t, const glm::dvec3& origin) const;
  /// The section at the start of segment `number`, or after the last segment.
  [[nodiscard]] const Section& joint(std::size_t number) const { return joints_[number]; }

  /// Whether a part of a segment is so short that its ends and its middle determine its rotation and scale: the
  /// trajectory turns by at most a right angle in it, and it spans at most one piece of each function.
  [[nodiscard]] bool is_short(std::size_t segment, double from, double to) const;

  /// The fraction of the trajectory's length, from 0 to 1, up to a position.
  [[nodiscard]] double length_fraction(std::size_t segment, double t) const;

 private:
  [[nodiscard]] Plane joint_plane(std::size_t number) const;
  [[nodiscard]] Section make_section(const glm::dvec3& origin, const Plane& plane, double fraction) const;
  void measure_lengths();

  Path path_;
  Orientation orientation_;
  std::vector<Segment> rotation_;
  std::vector<Segment> scale_;
  std::vector<double> lengths_;  ///< length up to each joint
  std::vector<Plane> planes_;    ///< plane at each joint
  std::vector<Section> joints_;
};

}  // namespace csgsim::swept
