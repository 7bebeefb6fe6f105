#include "host/convex/face_polygon.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <utility>

#include "host/convex/clip.h"

namespace csgsim::convex {

namespace {

/// A square in the plane through `around`, centred there, that extends by `reach` to each side.
std::vector<glm::dvec3> square(const glm::dvec3& around, const glm::dvec3& normal, double reach) {
  const auto [right, up] = plane_axes(normal);
  return {around - reach * (right + up), around + reach * (right - up), around + reach * (right + up),
          around - reach * (right - up)};
}

/// Like clipped(), with a buffer for the second polygon. Returns whether the corners changed.
bool clip_corners(std::vector<glm::dvec3>& corners, const facet::Plane& plane, double near,
                  std::vector<glm::dvec3>& kept) {
  double deepest = 0;
  double farthest = 0;
  for (const glm::dvec3& corner : corners) {
    const double height = plane.height(corner);
    deepest = std::min(deepest, height);
    farthest = std::max(farthest, height);
  }
  kept.clear();
  if (deepest < -near && farthest <= near) return false;
  if (deepest < -near) {
    double at_here = plane.height(corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const glm::dvec3& here = corners[i];
      const glm::dvec3& next = corners[i + 1 < corners.size() ? i + 1 : 0];
      const double at_next = plane.height(next);
      if (at_here <= near) kept.push_back(here);
      if ((at_here < -near && at_next > near) || (at_here > near && at_next < -near))
        kept.push_back(here + at_here / (at_here - at_next) * (next - here));
      at_here = at_next;
    }
  }
  if (kept.size() < 3) kept.clear();
  std::swap(corners, kept);
  return true;
}

/// A bounding box of corners, for a quick test that all of them are behind a plane.
class CornerBounds {
 public:
  explicit CornerBounds(const std::vector<glm::dvec3>& corners) {
    const auto [low, high] = facet::box_of(corners);
    middle_ = (low + high) / 2.0;
    half_ = (high - low) * 0.5000001;
  }

  /// Whether the whole box is certainly farther behind the plane than `near`.
  [[nodiscard]] bool is_behind(const facet::Plane& plane, double near) const {
    const glm::dvec3& n = plane.normal;
    const double reach = std::abs(n.x) * half_.x + std::abs(n.y) * half_.y + std::abs(n.z) * half_.z;
    return plane.height(middle_) + reach < -2.0 * near;
  }

 private:
  glm::dvec3 middle_{};
  glm::dvec3 half_{};
};

}  // namespace

std::array<glm::dvec3, 2> plane_axes(const glm::dvec3& normal) {
  const glm::dvec3 least = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(normal, least));
  return {right, glm::cross(normal, right)};
}

std::vector<glm::dvec3> clipped(std::vector<glm::dvec3> corners, const facet::Plane& plane, double tolerance) {
  std::vector<glm::dvec3> kept;
  clip_corners(corners, plane, tolerance, kept);
  return corners;
}

std::vector<glm::dvec3> face_polygon(const facet::Convex& solid, std::uint32_t plane, const facet::PlaneTable& planes) {
  if (solid.box.empty()) return {};
  const facet::Plane& own = planes.planes()[plane];
  const double near = tolerance(planes);
  const glm::dvec3 middle = solid.box.centre() - planes.centre();
  const double size = solid.box.diagonal();
  const double height = own.height(middle);
  if (!(std::abs(height) <= size + near)) return {};
  const double margin = 0.1 * size + 10.0 * near;
  // The square covers the intersection of the plane and the box, and extends beyond it by more than the margin.
  std::vector<glm::dvec3> corners = square(middle - height * own.normal, own.normal, 2.0 * (size + margin));
  std::vector<glm::dvec3> kept;
  CornerBounds around(corners);
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    if (halfspace.plane == plane) continue;
    const facet::Plane outward = outward_plane(halfspace, planes);
    if (around.is_behind(outward, near) || !clip_corners(corners, outward, near, kept)) continue;
    if (corners.empty()) return {};
    around = CornerBounds(corners);
  }
  const auto is_beyond = [&](const glm::dvec3& corner) {
    return glm::any(glm::greaterThan(glm::abs(corner - middle), (solid.box.high - solid.box.low) / 2.0 + margin));
  };
  if (std::any_of(corners.begin(), corners.end(), is_beyond)) return {};
  return corners;
}

}  // namespace csgsim::convex
