#include "host/convex/face_polygon.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "host/convex/clip.h"

namespace csgsim::convex {

namespace {

/// A convex polygon that is cut by one half-space after another.
class Polygon {
 public:
  explicit Polygon(std::vector<glm::dvec3> corners) : corners_(std::move(corners)) {}

  /// Leaves what is in the half-space; corners within `near` of its plane stay where they are. Nothing where none is
  /// farther in.
  void clip(const facet::Plane& outward, double near) {
    heights_.clear();
    double deepest = 0;
    for (const glm::dvec3& corner : corners_) {
      const double height = glm::dot(outward.normal, corner) + outward.offset;
      deepest = std::min(deepest, height);
      heights_.push_back(height);
    }
    if (deepest >= -near) corners_.clear();
    kept_.clear();
    for (std::size_t i = 0; i < corners_.size(); ++i) {
      const std::size_t next = i + 1 < corners_.size() ? i + 1 : 0;
      if (heights_[i] <= near) kept_.push_back(corners_[i]);
      const bool crosses = (heights_[i] < -near && heights_[next] > near) ||  //
                           (heights_[i] > near && heights_[next] < -near);
      if (!crosses) continue;
      const double part = heights_[i] / (heights_[i] - heights_[next]);
      kept_.push_back(corners_[i] + part * (corners_[next] - corners_[i]));
    }
    std::swap(corners_, kept_);
    if (corners_.size() < 3) corners_.clear();
  }

  [[nodiscard]] bool empty() const { return corners_.empty(); }
  [[nodiscard]] std::vector<glm::dvec3> take() { return std::move(corners_); }

 private:
  std::vector<glm::dvec3> corners_;
  std::vector<glm::dvec3> kept_;
  std::vector<double> heights_;
};

/// A square in a plane around a point of it, `reach` long each way.
std::vector<glm::dvec3> square(const glm::dvec3& around, const glm::dvec3& normal, double reach) {
  const auto [right, up] = axes_in(normal);
  return {around - reach * (right + up), around + reach * (right - up), around + reach * (right + up),
          around - reach * (right - up)};
}

}  // namespace

std::array<glm::dvec3, 2> axes_in(const glm::dvec3& normal) {
  const glm::dvec3 least = std::abs(normal.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 right = glm::normalize(glm::cross(normal, least));
  return {right, glm::cross(normal, right)};
}

std::vector<glm::dvec3> face_polygon(const facet::Convex& solid, std::uint32_t plane, const facet::PlaneTable& planes) {
  if (solid.box.empty()) return {};
  const facet::Plane& own = planes.planes()[plane];
  const double near = tolerance(planes);
  const glm::dvec3 middle = solid.box.centre() - planes.centre();
  const double size = glm::length(solid.box.high - solid.box.low);
  const double height = glm::dot(own.normal, middle) + own.offset;
  if (!(std::abs(height) <= size + near)) return {};
  const double margin = 0.1 * size + 10.0 * near;
  // From its middle the square reaches past all of the box that is in the plane, and more than the margin farther.
  Polygon polygon(square(middle - height * own.normal, own.normal, 2.0 * (size + margin)));
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    if (halfspace.plane == plane) continue;
    polygon.clip(outward_plane(halfspace, planes), near);
    if (polygon.empty()) return {};
  }
  std::vector<glm::dvec3> corners = polygon.take();
  const auto is_beyond = [&](const glm::dvec3& corner) {
    return glm::any(glm::greaterThan(glm::abs(corner - middle), (solid.box.high - solid.box.low) / 2.0 + margin));
  };
  if (std::any_of(corners.begin(), corners.end(), is_beyond)) return {};
  return corners;
}

}  // namespace csgsim::convex
