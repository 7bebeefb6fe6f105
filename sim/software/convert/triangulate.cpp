#include "sim/software/convert/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "sim/software/convert/seen.h"

namespace csgsim::software::convert {

namespace {

using Kernel = ProjectionKernel;
using Point = Kernel::Point_2;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
/// Winding number of a face, once known.
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel,
                                                CGAL::Triangulation_face_base_with_info_2<std::optional<int>, Kernel>>;
using Storage = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Storage,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// A round may pass through its first corner again; degenerate triangles there contribute no sides.
void add_fan(const std::vector<std::uint32_t>& round, std::vector<Triangle>& triangles) {
  for (std::size_t i = 1; i + 1 < round.size(); ++i)
    if (round[i] != round[0] && round[i + 1] != round[0]) triangles.push_back({round[0], round[i], round[i + 1]});
}

/// Whether the turn is clearly to the left. If it is not, for instance at a corner that rounding has moved off a
/// straight side, triangles from another corner may be slivers along that side.
bool turns_left(const Point& before, const Point& here, const Point& after) {
  constexpr double min_sine = 1e-3;
  const Kernel::Vector_2 in = here - before;
  const Kernel::Vector_2 out = after - here;
  return CGAL::determinant(in, out) > min_sine * std::sqrt(in.squared_length() * out.squared_length());
}

bool is_convex(const std::vector<std::uint32_t>& round, const PlaneProjection& seen) {
  const std::size_t count = round.size();
  std::size_t lowest = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const Point before = seen(round[(i + count - 1) % count]);
    const Point here = seen(round[i]);
    const Point after = seen(round[(i + 1) % count]);
    if (!turns_left(before, here, after)) return false;
    if (here < before && here < after) ++lowest;
  }
  return lowest == 1;
}

/// The constrained triangulation of an outline's points and sides. Impossible if sides cross, or if points coincide in
/// the projection.
class Covering {
 public:
  Covering(const Outline& outline, const PlaneProjection& seen) {
    for (const Side& side : outline.sides)
      for (const std::uint32_t point : side) handle_of(point, seen);
    is_possible_ = handles_.size() == triangulation_.number_of_vertices();
    for (const Side& side : outline.sides) {
      if (!is_possible_) return;
      triangulation_.insert_constraint(handles_.at(side[0]), handles_.at(side[1]));
      ++surplus_[side];
    }
  }

  [[nodiscard]] bool is_possible() const { return is_possible_; }

  TwoSidedTriangles triangulate_two_sided() {
    if (triangulation_.dimension() < 2) return {};
    spread();
    TwoSidedTriangles found;
    for (const Triangulation::Face_handle face : triangulation_.finite_face_handles()) {
      const int times = face->info().value_or(0);
      Triangle triangle{face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
      if (times < 0) std::swap(triangle[1], triangle[2]);
      std::vector<Triangle>& side = times < 0 ? found.back : found.front;
      for (int i = 0; i < std::abs(times); ++i) side.push_back(triangle);
    }
    return found;
  }

 private:
  void handle_of(std::uint32_t point, const PlaneProjection& seen) {
    if (handles_.contains(point)) return;
    const Triangulation::Vertex_handle handle = triangulation_.insert(seen(point), near_);
    handle->info() = point;
    near_ = handle->face();
    handles_.emplace(point, handle);
  }

  [[nodiscard]] int surplus(std::uint32_t from, std::uint32_t to) const {
    const auto found = surplus_.find({from, to});
    return found == surplus_.end() ? 0 : found->second;
  }

  /// Propagates winding numbers from the infinite face inwards.
  void spread() {
    std::vector<Triangulation::Face_handle> open{triangulation_.infinite_face()};
    open.front()->info() = 0;
    while (!open.empty()) {
      const Triangulation::Face_handle face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Triangulation::Face_handle other = face->neighbor(i);
        if (other->info()) continue;
        int times = *face->info();
        if (face->is_constrained(i)) {
          // The side runs along the face in its direction, and along the neighbour in the opposite direction.
          const std::uint32_t from = face->vertex(Triangulation::ccw(i))->info();
          const std::uint32_t to = face->vertex(Triangulation::cw(i))->info();
          times += surplus(to, from) - surplus(from, to);
        }
        other->info() = times;
        open.push_back(other);
      }
    }
  }

  bool is_possible_ = false;
  Triangulation triangulation_;
  Triangulation::Face_handle near_;
  std::map<std::uint32_t, Triangulation::Vertex_handle> handles_;
  std::map<Side, int> surplus_;
};

std::vector<Triangle> all_of(const TwoSidedTriangles& sides) {
  std::vector<Triangle> all = sides.front;
  all.insert(all.end(), sides.back.begin(), sides.back.end());
  return all;
}

/// Whether the unmatched sides of the triangles are exactly the sides of the outline.
bool is_bounded_by(const std::vector<Triangle>& triangles, const Outline& outline) {
  std::map<Side, int> sums;
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t from = triangle[i];
      const std::uint32_t to = triangle[(i + 1) % 3];
      sums[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
    }
  }
  for (const Side& side : outline.sides)
    sums[{std::min(side[0], side[1]), std::max(side[0], side[1])}] -= side[0] < side[1] ? 1 : -1;
  return std::ranges::all_of(sums, [](const auto& sum) { return sum.second == 0; });
}

}  // namespace

bool is_flat(const std::vector<glm::dvec3>& points, const std::vector<std::uint32_t>& round) {
  for (int axis = 0; axis < 3; ++axis) {
    const double level = points[round.front()][axis];
    if (std::ranges::all_of(round, [&](std::uint32_t corner) { return points[corner][axis] == level; })) return true;
  }
  const auto at = [&](std::size_t i) {
    const glm::dvec3& point = points[round[i]];
    return Kernel::Point_3(point.x, point.y, point.z);
  };
  std::size_t third = 2;
  while (third < round.size() && CGAL::collinear(at(0), at(1), at(third))) ++third;
  for (std::size_t i = third + 1; i < round.size(); ++i)
    if (CGAL::orientation(at(0), at(1), at(third), at(i)) != CGAL::COPLANAR) return false;
  return true;
}

std::vector<std::vector<std::uint32_t>> rounds_of(const Outline& outline) {
  std::vector<Side> sides = outline.sides;
  std::ranges::sort(sides);
  std::vector<bool> is_taken(sides.size(), false);
  std::vector<std::vector<std::uint32_t>> rounds;
  for (std::size_t first = 0; first < sides.size(); ++first) {
    std::vector<std::uint32_t> round;
    std::size_t at = first;
    while (at < sides.size() && !is_taken[at]) {
      is_taken[at] = true;
      round.push_back(sides[at][0]);
      const std::uint32_t next = sides[at][1];
      at = static_cast<std::size_t>(std::ranges::lower_bound(sides, Side{next, 0}) - sides.begin());
      while (at < sides.size() && sides[at][0] == next && is_taken[at]) ++at;
      if (at < sides.size() && sides[at][0] != next) break;
    }
    if (!round.empty()) rounds.push_back(std::move(round));
  }
  return rounds;
}

std::optional<TwoSidedTriangles> triangulate_two_sided(const std::vector<glm::dvec3>& points, const Outline& outline) {
  try {
    Covering covering(outline, PlaneProjection(points, outline.outward));
    if (!covering.is_possible()) return std::nullopt;
    TwoSidedTriangles sides = covering.triangulate_two_sided();
    if (is_bounded_by(all_of(sides), outline)) return sides;
  } catch (const Triangulation::Intersection_of_constraints_exception&) {
    // The caller receives an empty result.
  }
  return std::nullopt;
}

std::vector<Triangle> triangulate(const std::vector<glm::dvec3>& points, const Outline& outline) {
  const PlaneProjection seen(points, outline.outward);
  const std::vector<std::vector<std::uint32_t>> rounds = rounds_of(outline);
  if (rounds.size() == 1 && is_convex(rounds.front(), seen)) {
    std::vector<Triangle> triangles;
    add_fan(rounds.front(), triangles);
    return triangles;
  }
  if (const std::optional<TwoSidedTriangles> sides = triangulate_two_sided(points, outline)) return all_of(*sides);
  std::vector<Triangle> triangles;
  for (const std::vector<std::uint32_t>& round : rounds) add_fan(round, triangles);
  return triangles;
}

}  // namespace csgsim::software::convert
