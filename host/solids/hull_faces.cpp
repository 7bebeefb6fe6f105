#include "host/solids/hull_faces.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

#include "host/model/exact_coordinate.h"
#include "host/solids/exact_sign.h"
#include "host/solids/neighbours.h"

namespace csgsim::solids {

namespace {

using Loop = std::vector<std::uint32_t>;

bool are_in_one_plane(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, const glm::dvec3& d) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;
  const auto found = sign_of_determinant({{{b, a}, {c, a}, {d, a}}});
  if (found) return *found == 0;
  const auto exact = [](const glm::dvec3& point) { return model::exact_point<Point>(point.x, point.y, point.z); };
  return CGAL::coplanar(exact(a), exact(b), exact(c), exact(d));
}

/// Finds, for each triangle, the first triangle of its face. A face is a maximal set of adjacent triangles in one
/// plane.
class CoplanarGroups {
 public:
  explicit CoplanarGroups(const Mesh& hull)
      : hull_(hull), neighbours_(find_neighbours(hull)), parent_(hull.faces.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    for (std::uint32_t face = 0; face < parent_.size(); ++face) {
      for (std::uint32_t side = 0; side < 3; ++side) join(face, beyond(face, side));
    }
  }

  [[nodiscard]] std::uint32_t beyond(std::uint32_t face, std::uint32_t side) const {
    return neighbours_.face[neighbours_.first_side[face] + side];
  }

  std::uint32_t find(std::uint32_t face) {
    while (parent_[face] != face) face = parent_[face] = parent_[parent_[face]];
    return face;
  }

 private:
  void join(std::uint32_t one, std::uint32_t other) {
    if (other < one) return;
    const auto at = [this](std::uint32_t point) { return hull_.points[point]; };
    const Loop& face = hull_.faces[one];
    for (const std::uint32_t corner : hull_.faces[other]) {
      if (!are_in_one_plane(at(face[0]), at(face[1]), at(face[2]), at(corner))) return;
    }
    const auto [low, high] = std::minmax({find(one), find(other)});
    parent_[high] = low;
  }

  const Mesh& hull_;
  Neighbours neighbours_;
  std::vector<std::uint32_t> parent_;
};

/// An edge between two faces, in the direction in which `face` runs along it.
struct Rim {
  std::uint32_t face = 0;
  std::uint32_t from = 0;
  std::uint32_t to = 0;

  friend bool operator<(const Rim& a, const Rim& b) {
    return std::tie(a.face, a.from, a.to) < std::tie(b.face, b.from, b.to);
  }
};

std::vector<Rim> collect_rims(const Mesh& hull) {
  CoplanarGroups grouping(hull);
  std::vector<Rim> rims;
  for (std::uint32_t face = 0; face < hull.faces.size(); ++face) {
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t own = grouping.find(face);
      if (grouping.find(grouping.beyond(face, side)) == own) continue;
      rims.push_back({own, hull.faces[face][side], hull.faces[face][(side + 1) % 3]});
    }
  }
  std::sort(rims.begin(), rims.end());
  return rims;
}

/// The corners of each face in order.
std::vector<Loop> collect_loops(const std::vector<Rim>& rims) {
  std::vector<Loop> loops;
  for (auto begin = rims.begin(); begin != rims.end();) {
    const auto end = std::find_if(begin, rims.end(), [&](const Rim& rim) { return rim.face != begin->face; });
    Loop& loop = loops.emplace_back();
    std::uint32_t corner = begin->from;
    do {
      loop.push_back(corner);
      corner = std::lower_bound(begin, end, Rim{begin->face, corner, 0})->to;
    } while (corner != begin->from);
    begin = end;
  }
  return loops;
}

/// Numbers the points at which at least three faces meet, in the order of their coordinates. Other points, inside a
/// face or an edge, get `none`.
std::vector<std::uint32_t> number_corners(const Mesh& hull, const std::vector<Loop>& loops, Mesh& made) {
  std::vector<std::uint32_t> uses(hull.points.size());
  for (const Loop& loop : loops) {
    for (const std::uint32_t corner : loop) ++uses[corner];
  }
  std::vector<std::uint32_t> corners;
  for (std::uint32_t i = 0; i < uses.size(); ++i) {
    if (uses[i] > 2) corners.push_back(i);
  }
  const auto place = [&](std::uint32_t corner) {
    const glm::dvec3& point = hull.points[corner];
    return std::tuple(point.x, point.y, point.z);
  };
  std::ranges::sort(corners, {}, place);
  std::vector<std::uint32_t> numbers(hull.points.size(), none);
  for (const std::uint32_t corner : corners) {
    numbers[corner] = static_cast<std::uint32_t>(made.points.size());
    made.points.push_back(hull.points[corner]);
  }
  return numbers;
}

}  // namespace

Mesh canonical_hull(const Mesh& hull) {
  std::vector<Loop> loops = collect_loops(collect_rims(hull));
  Mesh made;
  const std::vector<std::uint32_t> numbers = number_corners(hull, loops, made);
  for (Loop& loop : loops) {
    for (std::uint32_t& corner : loop) corner = numbers[corner];
    std::erase(loop, none);
    std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  }
  std::ranges::sort(loops);
  for (const Loop& loop : loops) {
    for (std::size_t i = 2; i < loop.size(); ++i) made.faces.push_back({loop[0], loop[i - 1], loop[i]});
  }
  return made;
}

}  // namespace csgsim::solids
