#include "host/swept/flat.h"

#include <glm/geometric.hpp>

namespace csgsim::swept {

double distance_to_segment(const glm::dvec3& point, const glm::dvec3& from, const glm::dvec3& to) {
  const glm::dvec3 along = to - from;
  const double length2 = glm::dot(along, along);
  if (length2 == 0) return glm::distance(point, from);
  const double part = glm::clamp(glm::dot(point - from, along) / length2, 0.0, 1.0);
  return glm::distance(point, from + part * along);
}

double distance_to_plane(const glm::dvec3& point, const std::array<glm::dvec3, 3>& plane) {
  const glm::dvec3 one = plane[1] - plane[0];
  const glm::dvec3 other = plane[2] - plane[0];
  const glm::dvec3 normal = glm::cross(one, other);
  const double length = glm::length(normal);
  constexpr double sliver = 1e-9;
  const double reach = glm::max(glm::dot(one, one), glm::dot(other, other));
  if (length > sliver * reach) return glm::abs(glm::dot(point - plane[0], normal)) / length;
  const glm::dvec3 third = plane[2] - plane[1];
  if (glm::dot(third, third) > reach) return distance_to_segment(point, plane[1], plane[2]);
  return glm::dot(one, one) >= glm::dot(other, other) ? distance_to_segment(point, plane[0], plane[1])
                                                      : distance_to_segment(point, plane[0], plane[2]);
}

bool is_flat(const std::array<glm::dvec3, 4>& corners, const glm::dvec3& middle, double tolerance,
             SubdivisionCounts& counts) {
  // If a side collapses to a point, as at a tip, the plane passes through the other three corners.
  const bool has_tip = corners[sw] == corners[se] || corners[sw] == corners[nw];
  const std::array plane =
      has_tip ? std::array{corners[ne], corners[nw], corners[se]} : std::array{corners[sw], corners[se], corners[nw]};
  counts.tests += 2;
  // The arithmetic of one normal and its length, then of two distances.
  counts.arithmetic += {6 + 3 + 2 + 2 * 5, 6 + 3 + 1 + 2 * 3, 0, 1};
  return distance_to_plane(has_tip ? corners[sw] : corners[ne], plane) <= tolerance &&
         distance_to_plane(middle, plane) <= tolerance;
}

}  // namespace csgsim::swept
