#include "host/solids/flat_outline.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <iterator>
#include <tuple>

#include "host/model/exact_coordinate.h"
#include "host/solids/neighbours.h"

namespace csgsim::solids {

namespace {

/// The predecessor and successor of each point along the sides.
struct PathNeighbours {
  std::vector<std::uint32_t> previous;
  std::vector<std::uint32_t> next;
};

PathNeighbours link_path(std::size_t points, std::span<const Link> sides) {
  PathNeighbours made{std::vector<std::uint32_t>(points, none), std::vector<std::uint32_t>(points, none)};
  for (const auto& [from, to] : sides) {
    made.next[from] = to;
    made.previous[to] = from;
  }
  return made;
}

bool within_box(const ProjectedPoint& a, const ProjectedPoint& b, const ProjectedPoint& point) {
  return std::min(a.s, b.s) <= point.s && point.s <= std::max(a.s, b.s) && std::min(a.t, b.t) <= point.t &&
         point.t <= std::max(a.t, b.t);
}

bool is_on(const ProjectedPoint& a, const ProjectedPoint& b, const ProjectedPoint& point) {
  return turn(a, b, point) == 0 && within_box(a, b, point);
}

/// Two sides of an outline.
class SidePair {
 public:
  SidePair(std::span<const ProjectedPoint> points, const Link& one, const Link& other)
      : points_(points), one_(one), other_(other) {}

  [[nodiscard]] bool meet() const {
    const auto [a, b] = one_;
    const auto [c, d] = other_;
    // Sides with a common end must not overlap.
    if (b == c) return is_on(at(a), at(b), at(d)) || is_on(at(c), at(d), at(a));
    if (a == d) return is_on(at(a), at(b), at(c)) || is_on(at(c), at(d), at(b));
    const bool parts_second = (turn(at(a), at(b), at(c)) > 0) != (turn(at(a), at(b), at(d)) > 0);
    const bool parts_first = (turn(at(c), at(d), at(a)) > 0) != (turn(at(c), at(d), at(b)) > 0);
    return (parts_first && parts_second) || is_on(at(a), at(b), at(c)) || is_on(at(a), at(b), at(d)) ||
           is_on(at(c), at(d), at(a)) || is_on(at(c), at(d), at(b));
  }

 private:
  [[nodiscard]] const ProjectedPoint& at(std::uint32_t point) const { return points_[point]; }

  std::span<const ProjectedPoint> points_;
  Link one_;
  Link other_;
};

/// The interior between two sides that the sweep has reached.
struct Region {
  Link upper;                   ///< left end, right end
  Link lower;                   ///< left end, right end
  std::uint32_t last = 0;       ///< last point of the region that the sweep has visited
  bool needs_diagonal = false;  ///< `last` is a reflex corner that still needs a diagonal to its right
};

class OutlineSweep {
 public:
  OutlineSweep(std::span<const ProjectedPoint> points, std::span<const Link> sides)
      : points_(points), around_(link_path(points.size(), sides)) {
    for (const Link& side : sides) order_.push_back(side.first);
    std::stable_sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) {
      return std::tie(points[a].s, points[a].t) < std::tie(points[b].s, points[b].t);
    });
  }

  std::vector<Link> operator()() {
    for (const std::uint32_t point : order_) visit(point);
    return std::move(diagonals_);
  }

 private:
  void visit(std::uint32_t point) {
    const std::uint32_t previous = around_.previous[point];
    const std::uint32_t next = around_.next[point];
    const bool from_left = precedes(points_[previous], points_[point]);
    const bool to_left = precedes(points_[next], points_[point]);
    const bool is_convex = turn(points_[previous], points_[point], points_[next]) > 0;
    if (!from_left && !to_left) {
      if (!is_convex) return split(point);
      regions_.push_back({{point, previous}, {point, next}, point});
    } else if (from_left && to_left) {
      if (!is_convex) return merge(point);
      regions_.erase(settled(ending(&Region::upper, point), point));
    } else if (to_left) {
      pass(ending(&Region::upper, point), point).upper = {point, previous};
    } else {
      pass(ending(&Region::lower, point), point).lower = {point, next};
    }
  }

  using At = std::vector<Region>::iterator;

  /// The region whose upper or lower side ends at the point.
  At ending(Link Region::*side, std::uint32_t point) {
    return std::find_if(regions_.begin(), regions_.end(),
                        [&](const Region& region) { return (region.*side).second == point; });
  }

  /// Adds the pending diagonal of the region's last point, if any.
  At settled(At region, std::uint32_t point) {
    if (region->needs_diagonal) diagonals_.emplace_back(region->last, point);
    region->needs_diagonal = false;
    return region;
  }

  Region& pass(At region, std::uint32_t point) {
    settled(region, point)->last = point;
    return *region;
  }

  [[nodiscard]] bool holds(const Region& region, std::uint32_t point) const {
    return turn(points_[region.upper.first], points_[region.upper.second], points_[point]) < 0 &&
           turn(points_[region.lower.first], points_[region.lower.second], points_[point]) > 0;
  }

  void split(std::uint32_t point) {
    const At region = std::find_if(regions_.begin(), regions_.end(),
                                   [&](const Region& candidate) { return holds(candidate, point); });
    if (region == regions_.end()) return;
    diagonals_.emplace_back(region->last, point);
    const Link upper = std::exchange(region->upper, {point, around_.previous[point]});
    region->last = point;
    region->needs_diagonal = false;
    regions_.push_back({upper, {point, around_.next[point]}, point});
  }

  void merge(std::uint32_t point) {
    const Region above = *settled(ending(&Region::lower, point), point);
    const At below = settled(ending(&Region::upper, point), point);
    below->upper = above.upper;
    below->last = point;
    below->needs_diagonal = true;
    regions_.erase(ending(&Region::lower, point));
  }

  std::span<const ProjectedPoint> points_;
  PathNeighbours around_;
  std::vector<std::uint32_t> order_;
  std::vector<Region> regions_;
  std::vector<Link> diagonals_;
};

}  // namespace

int turn(const ProjectedPoint& a, const ProjectedPoint& b, const ProjectedPoint& c) {
  using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_2;
  const auto exact = [](const ProjectedPoint& point) { return model::exact_point<Point>(point.s, point.t); };
  return CGAL::orientation(exact(a), exact(b), exact(c));
}

bool is_simple(std::span<const ProjectedPoint> points, std::span<const Link> sides) {
  std::vector<std::uint32_t> leaving(points.size(), 0);
  std::vector<std::uint32_t> ending(points.size(), 0);
  for (const auto& [from, to] : sides) {
    if (++leaving[from] > 1 || ++ending[to] > 1) return false;
  }
  if (leaving != ending) return false;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    for (std::size_t k = i + 1; k < sides.size(); ++k) {
      if (SidePair(points, sides[i], sides[k]).meet()) return false;
    }
  }
  return true;
}

std::vector<Link> monotone_diagonals(std::span<const ProjectedPoint> points, std::span<const Link> sides) {
  return OutlineSweep(points, sides)();
}

}  // namespace csgsim::solids
