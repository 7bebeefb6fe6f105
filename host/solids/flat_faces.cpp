#include "host/solids/flat_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "host/model/exact_coordinate.h"

namespace csgsim::solids {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using FlatPoint = Kernel::Point_2;
using Face = std::vector<std::uint32_t>;

/// A face projected along its dominant axis, counter-clockwise.
std::vector<FlatPoint> projection(const Mesh& mesh, const Face& face, const glm::dvec3& normal) {
  int axis = 0;
  for (int i = 1; i < 3; ++i) {
    if (std::abs(normal[i]) > std::abs(normal[axis])) axis = i;
  }
  int u = (axis + 1) % 3;
  int v = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(u, v);
  std::vector<FlatPoint> points;
  points.reserve(face.size());
  for (const std::uint32_t corner : face) {
    const glm::dvec3& point = mesh.points[corner];
    points.push_back(model::exact_point<FlatPoint>(point[u], point[v]));
  }
  return points;
}

bool is_convex(const std::vector<FlatPoint>& points) {
  int turns = 0;
  const std::size_t count = points.size();
  for (std::size_t i = 0; i < count; ++i) {
    const FlatPoint& here = points[i];
    const FlatPoint& next = points[(i + 1) % count];
    const FlatPoint& after = points[(i + 2) % count];
    if (CGAL::orientation(here, next, after) != CGAL::LEFT_TURN) {
      if (CGAL::orientation(here, next, after) == CGAL::RIGHT_TURN) return false;
      if (!CGAL::collinear_are_ordered_along_line(here, next, after)) return false;
    }
    if (CGAL::lexicographically_xy_smaller(here, next) != CGAL::lexicographically_xy_smaller(next, after)) ++turns;
  }
  return turns == 2;
}

bool contains(const std::array<FlatPoint, 3>& triangle, const FlatPoint& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (CGAL::orientation(triangle[i], triangle[(i + 1) % 3], point) == CGAL::RIGHT_TURN) return false;
  }
  return point != triangle[0] && point != triangle[1] && point != triangle[2];
}

/// Triangulates a face by ear clipping. Holes may be joined to the outline by edges that it follows in both directions.
class EarClipper {
 public:
  EarClipper(const Face& face, const std::vector<FlatPoint>& points) : face_(face), points_(points) {
    for (std::size_t i = 0; i < face.size(); ++i) left_.push_back(i);
  }

  std::vector<Face> operator()() {
    while (left_.size() > 3) cut(next());
    cut(1);
    return std::move(triangles_);
  }

 private:
  [[nodiscard]] std::array<std::size_t, 3> corner(std::size_t i) const {
    const std::size_t count = left_.size();
    return {left_[(i + count - 1) % count], left_[i % count], left_[(i + 1) % count]};
  }

  /// The next ear after the last one; if a face that crosses itself has no ear, the next corner.
  [[nodiscard]] std::size_t next() const {
    for (std::size_t k = 0; k < left_.size(); ++k) {
      const std::size_t i = (from_ + k) % left_.size();
      if (is_ear(corner(i))) return i;
    }
    return from_ % left_.size();
  }

  [[nodiscard]] bool is_ear(const std::array<std::size_t, 3>& at) const {
    const std::array<FlatPoint, 3> triangle{points_[at[0]], points_[at[1]], points_[at[2]]};
    if (CGAL::orientation(triangle[0], triangle[1], triangle[2]) != CGAL::LEFT_TURN) return false;
    return std::none_of(left_.begin(), left_.end(),
                        [&](std::size_t other) { return contains(triangle, points_[other]); });
  }

  void cut(std::size_t i) {
    const auto [a, b, c] = corner(i);
    triangles_.push_back({face_[a], face_[b], face_[c]});
    left_.erase(left_.begin() + static_cast<std::ptrdiff_t>(i));
    from_ = i;
  }

  const Face& face_;
  const std::vector<FlatPoint>& points_;
  std::vector<std::size_t> left_;  ///< corners not yet cut off
  std::size_t from_ = 0;
  std::vector<Face> triangles_;
};

/// A triangle fan from the first corner, for a face whose parts cancel each other, like a bow tie; the face itself if
/// no triangle has area.
std::vector<Face> fan(const Mesh& mesh, const Face& face) {
  std::vector<Face> triangles;
  bool has_area = false;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    const Face& triangle = triangles.emplace_back(Face{face[0], face[i], face[i + 1]});
    has_area = has_area || glm::length(area_vector(mesh, triangle)) > 0;
  }
  if (!has_area) return {face};
  return triangles;
}

}  // namespace

glm::dvec3 area_vector(const Mesh& mesh, const Face& face) {
  const glm::dvec3 origin = mesh.points[face.front()];
  glm::dvec3 sum(0);
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    sum += glm::cross(mesh.points[face[i]] - origin, mesh.points[face[i + 1]] - origin);
  }
  return sum;
}

double max_plane_distance(const Mesh& mesh, const Face& face) {
  const glm::dvec3 vector = area_vector(mesh, face);
  const double length = glm::length(vector);
  if (length == 0) return 0;
  glm::dvec3 mean(0);
  for (const std::uint32_t corner : face) mean += mesh.points[corner] / static_cast<double>(face.size());
  double most = 0;
  for (const std::uint32_t corner : face) {
    most = std::max(most, std::abs(glm::dot(vector / length, mesh.points[corner] - mean)));
  }
  return most;
}

double largest_coordinate(const Mesh& mesh) {
  double largest = 0;
  for (const glm::dvec3& point : mesh.points) {
    largest = std::max({largest, std::abs(point.x), std::abs(point.y), std::abs(point.z)});
  }
  return largest;
}

std::vector<Face> flat_convex_parts(const Mesh& mesh, const Face& face, double tolerance) {
  if (face.size() == 3) return {face};
  const glm::dvec3 vector = area_vector(mesh, face);
  if (glm::length(vector) == 0) return fan(mesh, face);
  const std::vector<FlatPoint> points = projection(mesh, face, vector);
  if (max_plane_distance(mesh, face) <= tolerance && is_convex(points)) return {face};
  return EarClipper(face, points)();
}

Mesh with_flat_convex_faces(const Mesh& mesh, double tolerance) {
  Mesh made{mesh.points, {}};
  made.faces.reserve(mesh.faces.size());
  for (const Face& face : mesh.faces) {
    for (Face& part : flat_convex_parts(mesh, face, tolerance)) made.faces.push_back(std::move(part));
  }
  return made;
}

}  // namespace csgsim::solids
