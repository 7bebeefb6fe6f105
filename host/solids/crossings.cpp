#include <CGAL/Bbox_3.h>
#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <utility>

#include "host/solids/check.h"
#include "host/solids/flat_faces.h"

namespace csgsim::solids {

namespace {

using FacePair = std::pair<std::uint32_t, std::uint32_t>;
using Box = CGAL::Box_intersection_d::Box_d<double, 3>;

struct Triangle {
  std::array<std::uint32_t, 3> corners;
  std::uint32_t face;
};

struct TriangleBox : Box {
  TriangleBox(const CGAL::Bbox_3& box, std::uint32_t number) : Box(box), triangle(number) {}

  std::uint32_t triangle;
};

/// The mesh as triangles, each with the index of its face.
std::vector<Triangle> make_triangles(const Mesh& mesh, double tolerance) {
  std::vector<Triangle> triangles;
  for (std::uint32_t i = 0; i < mesh.faces.size(); ++i) {
    for (const auto& face : flat_convex_parts(mesh, mesh.faces[i], tolerance)) {
      for (std::size_t k = 1; k + 1 < face.size(); ++k) triangles.push_back({{face[0], face[k], face[k + 1]}, i});
    }
  }
  return triangles;
}

struct Plane {
  glm::dvec3 normal;
  glm::dvec3 origin;

  [[nodiscard]] double height(const glm::dvec3& point) const { return glm::dot(normal, point - origin); }
};

/// The interval in which a triangle crosses a plane, measured along a line in that plane.
struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  double depth = 0;  ///< how far the triangle reaches from the plane, on the side where it reaches less far

  void extend(double place) {
    low = std::min(low, place);
    high = std::max(high, place);
  }
};

class CrossingFinder {
 public:
  CrossingFinder(const Mesh& mesh, double tolerance)
      : mesh_(mesh), tolerance_(tolerance), triangles_(make_triangles(mesh, tolerance)) {}

  /// The pairs of faces that cross, with the depth of each crossing.
  [[nodiscard]] std::map<FacePair, double> find() const {
    std::map<FacePair, double> found;
    std::vector<TriangleBox> boxes;
    for (std::uint32_t i = 0; i < triangles_.size(); ++i) boxes.emplace_back(box_of(triangles_[i]), i);
    CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const TriangleBox& a, const TriangleBox& b) {
      const Triangle& one = triangles_[a.triangle];
      const Triangle& other = triangles_[b.triangle];
      const FacePair faces = std::minmax(one.face, other.face);
      if (faces.first == faces.second) return;
      if (const double depth = crossing_depth(one, other); depth > 0) found[faces] = std::max(found[faces], depth);
    });
    return found;
  }

 private:
  [[nodiscard]] const glm::dvec3& point(const Triangle& triangle, std::size_t corner) const {
    return mesh_.points[triangle.corners[corner]];
  }

  [[nodiscard]] CGAL::Bbox_3 box_of(const Triangle& triangle) const {
    CGAL::Bbox_3 box;
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3& at = point(triangle, i);
      box += CGAL::Bbox_3(at.x, at.y, at.z, at.x, at.y, at.z);
    }
    return box;
  }

  [[nodiscard]] Plane triangle_plane(const Triangle& triangle) const {
    const glm::dvec3& origin = point(triangle, 0);
    const glm::dvec3 vector = glm::cross(point(triangle, 1) - origin, point(triangle, 2) - origin);
    const double size = glm::length(vector);
    return {size > 0 ? vector / size : glm::dvec3(0), origin};
  }

  /// The crossing of a triangle with a plane; empty unless the triangle reaches farther than the tolerance to both
  /// sides.
  [[nodiscard]] Interval crossed(const Triangle& triangle, const Plane& plane, const glm::dvec3& along) const {
    std::array<double, 3> heights{};
    std::array<double, 3> places{};
    for (std::size_t i = 0; i < 3; ++i) {
      heights[i] = plane.height(point(triangle, i));
      places[i] = glm::dot(along, point(triangle, i) - plane.origin);
    }
    const auto [least, most] = std::minmax_element(heights.begin(), heights.end());
    if (*least >= -tolerance_ || *most <= tolerance_) return {};
    Interval interval;
    interval.depth = std::min(-*least, *most);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (heights[i] == 0) interval.extend(places[i]);
      if (heights[i] * heights[next] >= 0) continue;
      interval.extend(places[i] + (places[next] - places[i]) * heights[i] / (heights[i] - heights[next]));
    }
    return interval;
  }

  /// How far two triangles reach past each other, or the length of their crossing if that is less; 0 if they do not
  /// cross or the crossing is no longer than the tolerance.
  [[nodiscard]] double crossing_depth(const Triangle& one, const Triangle& other) const {
    if (shared_corners(one, other) > 1) return 0;
    const Plane first = triangle_plane(one);
    const Plane second = triangle_plane(other);
    const glm::dvec3 along = glm::cross(first.normal, second.normal);
    const double slant = glm::length(along);
    if (slant == 0) return 0;
    // Both intervals are measured along the same line; `shift` aligns their origins.
    const Interval a = crossed(one, second, along / slant);
    const Interval b = crossed(other, first, along / slant);
    const double shift = glm::dot(along / slant, second.origin - first.origin);
    const double length = std::min(a.high + shift, b.high) - std::max(a.low + shift, b.low);
    return length > tolerance_ ? std::min({a.depth, b.depth, length}) : 0;
  }

  static int shared_corners(const Triangle& one, const Triangle& other) {
    int count = 0;
    for (const std::uint32_t corner : one.corners) {
      count += std::find(other.corners.begin(), other.corners.end(), corner) != other.corners.end() ? 1 : 0;
    }
    return count;
  }

  const Mesh& mesh_;
  double tolerance_;
  std::vector<Triangle> triangles_;
};

}  // namespace

std::optional<Crossing> find_crossing(const NumberedMesh& numbered, double tolerance) {
  const std::map<FacePair, double> found = CrossingFinder(numbered.mesh, tolerance).find();
  if (found.empty()) return std::nullopt;
  const auto deepest = std::ranges::max_element(found, {}, &std::pair<const FacePair, double>::second);
  const auto [one, other] =
      std::minmax(numbered.face_numbers[deepest->first.first], numbered.face_numbers[deepest->first.second]);
  return Crossing{one, other, deepest->second, found.size()};
}

}  // namespace csgsim::solids
