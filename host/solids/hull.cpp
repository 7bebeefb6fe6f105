#include "host/solids/hull.h"

#include <CGAL/Convex_hull_traits_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/convex_hull_3.h>

#include <algorithm>
#include <iterator>
#include <utility>
#include <vector>

#include "host/model/exact_coordinate.h"
#include "host/solids/exact_sign.h"
#include "host/solids/hull_faces.h"
#include "host/solids/pieces.h"

namespace csgsim::solids {

namespace {

/// Cost per point, in steps of work.
constexpr std::uint64_t hull_steps = 3'000;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Surface = CGAL::Surface_mesh<Point>;
using Triple = CGAL::Point_triple<Kernel>;

glm::dvec3 at(const Point& point) { return {point.x(), point.y(), point.z()}; }

/// Whether a point is in front of the plane of three others.
struct InFront {
  using result_type = bool;

  bool operator()(const Triple& plane, const Point& point) const {
    const glm::dvec3 origin = at(plane.p());
    const auto found = sign_of_determinant({{{at(plane.q()), origin}, {at(plane.r()), origin}, {at(point), origin}}});
    return found ? *found > 0 : CGAL::orientation(plane.p(), plane.q(), plane.r(), point) == CGAL::POSITIVE;
  }
};

/// Whether one point is farther behind the plane of three others than another point.
struct IsFartherBehind {
  using result_type = bool;

  bool operator()(const Triple& plane, const Point& one, const Point& other) const {
    const glm::dvec3 origin = at(plane.p());
    const auto found = sign_of_determinant({{{at(plane.q()), origin}, {at(plane.r()), origin}, {at(one), at(other)}}});
    return found ? *found < 0 : CGAL::has_smaller_signed_distance_to_plane(plane.p(), plane.q(), plane.r(), one, other);
  }
};

/// Replaces CGAL's own predicates, which fall back to rational numbers for the many coplanar points of solids.
struct Traits : CGAL::Convex_hull_traits_3<Kernel, Surface, CGAL::Tag_false> {
  using Has_on_positive_side_3 = InFront;
  using Less_signed_distance_to_plane_3 = IsFartherBehind;

  [[nodiscard]] InFront has_on_positive_side_3_object() const { return {}; }
  [[nodiscard]] IsFartherBehind less_signed_distance_to_plane_3_object() const { return {}; }
};

/// Whether four of the points are not in one plane.
bool have_volume(const std::vector<Point>& points) {
  if (points.empty()) return false;
  const auto end = points.end();
  const Point& a = points.front();
  const auto b = std::find_if(points.begin(), end, [&](const Point& p) { return p != a; });
  if (b == end) return false;
  const auto c = std::find_if(b, end, [&](const Point& p) { return !CGAL::collinear(a, *b, p); });
  if (c == end) return false;
  return std::any_of(c, end, [&](const Point& p) { return !CGAL::coplanar(a, *b, *c, p); });
}

}  // namespace

Mesh hull(std::span<const glm::dvec3> points, const Work& work) {
  work.charge(hull_steps * points.size(), "finding a convex hull");
  std::vector<Point> given;
  given.reserve(points.size());
  for (const glm::dvec3& point : points) given.push_back(model::exact_point<Point>(point.x, point.y, point.z));
  if (!have_volume(given)) return {};
  Surface surface;
  CGAL::convex_hull_3(given.begin(), given.end(), surface, Traits());
  Mesh made;
  made.points.reserve(surface.number_of_vertices());
  for (const auto vertex : surface.vertices()) {
    made.points.push_back(at(surface.point(vertex)));
  }
  for (const auto face : surface.faces()) {
    auto& corners = made.faces.emplace_back();
    for (const auto vertex : surface.vertices_around_face(surface.halfedge(face))) {
      corners.push_back(static_cast<std::uint32_t>(vertex.idx()));
    }
  }
  // The triangles that CGAL makes of a face depend on the addresses of its edges, so they are replaced.
  return canonical_hull(made);
}

std::optional<model::Polyhedron> hull_piece(std::span<const glm::dvec3> points, const Work& work) {
  Limits limits;
  limits.work = work;
  limits.tolerance = double_precision_tolerance;
  std::vector<model::Polyhedron> pieces = convex_pieces(hull(points, work), limits);
  if (pieces.empty()) return std::nullopt;
  return std::move(pieces.front());
}

}  // namespace csgsim::solids
