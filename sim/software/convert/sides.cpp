#include "sim/software/convert/sides.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/iterator/function_output_iterator.hpp>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>
#include <unordered_map>
#include <utility>

#include "host/facet/geometry.h"

namespace csgsim::software::convert {

namespace {

namespace bg = boost::geometry;
using Corner = bg::model::point<double, 3, bg::cs::cartesian>;
using Item = std::pair<Corner, std::uint32_t>;
using Tree = bg::index::rtree<Item, bg::index::quadratic<16>>;

constexpr std::uint32_t none = 0xffffffffU;
constexpr std::uint32_t several = none - 1;

Corner corner_of(const glm::dvec3& point) { return {point.x, point.y, point.z}; }

Side ordered(const Side& side) { return {std::min(side[0], side[1]), std::max(side[0], side[1])}; }

std::uint64_t key_of(const Side& side) { return static_cast<std::uint64_t>(side[0]) << 32U | side[1]; }

/// The points on the way from one end of a line to the other.
class PointsOnLines {
 public:
  PointsOnLines(const std::vector<glm::dvec3>& points, const std::vector<bool>& is_used, double tolerance)
      : points_(points),
        tolerance_(tolerance),
        size_(facet::box_of(points).diagonal()),
        tree_(items(points, is_used)) {}

  [[nodiscard]] std::vector<std::uint32_t> between(std::uint32_t from, std::uint32_t to) const {
    const glm::dvec3 start = points_[from];
    const glm::dvec3 way = points_[to] - start;
    const double length = glm::length(way);
    std::vector<std::pair<double, std::uint32_t>> found;
    // A slanting line is looked along in pieces, whose boxes hold less.
    const glm::dvec3 across = glm::abs(way);
    const double widest = std::max({across.x, across.y, across.z});
    const double second = across.x + across.y + across.z - widest - std::min({across.x, across.y, across.z});
    const int pieces = second > tolerance_ ? static_cast<int>(std::ceil(8.0 * std::min(1.0, 4.0 * length / size_))) : 1;
    for (int piece = 0; piece < pieces; ++piece) {
      const glm::dvec3 one = start + way * (static_cast<double>(piece) / pieces);
      const glm::dvec3 other = start + way * (static_cast<double>(piece + 1) / pieces);
      const bg::model::box<Corner> box(corner_of(glm::min(one, other) - tolerance_),
                                       corner_of(glm::max(one, other) + tolerance_));
      const auto add = [&](const Item& item) {
        const std::uint32_t point = item.second;
        if (point == from || point == to) return;
        const double along = glm::dot(points_[point] - start, way) / (length * length);
        if (along <= 0 || along >= 1) return;
        if (glm::distance(points_[point], start + along * way) <= tolerance_) found.emplace_back(along, point);
      };
      tree_.query(bg::index::intersects(box), boost::make_function_output_iterator(add));
    }
    std::ranges::sort(found);
    std::vector<std::uint32_t> points;
    for (const auto& [along, point] : found)
      if (points.empty() || points.back() != point) points.push_back(point);
    return points;
  }

 private:
  static std::vector<Item> items(const std::vector<glm::dvec3>& points, const std::vector<bool>& is_used) {
    std::vector<Item> items;
    for (std::uint32_t i = 0; i < points.size(); ++i)
      if (is_used[i]) items.emplace_back(corner_of(points[i]), i);
    return items;
  }

  const std::vector<glm::dvec3>& points_;
  double tolerance_;
  double size_;  ///< of all points
  Tree tree_;
};

/// Of each point the two others that sides join it to, if they are on one line; else `several` or `none`.
std::vector<Side> straight_neighbours(const Outlines& outlines, double tolerance) {
  std::vector<Side> neighbours(outlines.points.size(), Side{none, none});
  const auto note = [&](std::uint32_t at, std::uint32_t other) {
    Side& known = neighbours[at];
    if (known[0] == other || known[1] == other || known[0] == several) return;
    if (known[0] == none) {
      known[0] = other;
    } else if (known[1] == none) {
      known[1] = other;
    } else {
      known = {several, several};
    }
  };
  for (const Outline& outline : outlines.outlines) {
    for (const Side& side : outline.sides) {
      note(side[0], side[1]);
      note(side[1], side[0]);
    }
  }
  for (std::uint32_t i = 0; i < neighbours.size(); ++i) {
    Side& known = neighbours[i];
    if (known[0] == several || known[1] == none) {
      known = {none, none};
      continue;
    }
    const glm::dvec3 from = outlines.points[known[0]];
    const glm::dvec3 way = outlines.points[known[1]] - from;
    const double along = glm::dot(outlines.points[i] - from, way) / glm::dot(way, way);
    const bool is_on = along > 0 && along < 1 && glm::distance(outlines.points[i], from + along * way) <= tolerance;
    if (!is_on) known = {none, none};
  }
  return neighbours;
}

}  // namespace

void cancel(std::vector<Side>& sides) {
  std::erase_if(sides, [](const Side& side) { return side[0] == side[1]; });
  std::ranges::sort(sides, [](const Side& one, const Side& other) {
    const Side a = ordered(one);
    const Side b = ordered(other);
    return a != b ? a < b : one < other;
  });
  std::size_t kept = 0;
  for (std::size_t begin = 0; begin < sides.size();) {
    std::size_t end = begin;
    const Side line = ordered(sides[begin]);
    std::ptrdiff_t surplus = 0;  // that run from the lower number to the higher
    for (; end < sides.size() && ordered(sides[end]) == line; ++end) surplus += sides[end] == line ? 1 : -1;
    const Side left = surplus > 0 ? line : Side{line[1], line[0]};
    for (std::ptrdiff_t i = 0; i < std::abs(surplus); ++i) sides[kept++] = left;
    begin = end;
  }
  sides.resize(kept);
}

bool end_at_points(Outlines& outlines, double tolerance) {
  std::vector<bool> is_used(outlines.points.size(), false);
  for (const Outline& outline : outlines.outlines)
    for (const Side& side : outline.sides) is_used[side[0]] = is_used[side[1]] = true;
  const PointsOnLines lines(outlines.points, is_used, tolerance);
  std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> known;
  bool any = false;
  for (Outline& outline : outlines.outlines) {
    std::vector<Side> sides;
    bool changed = false;
    for (const Side& side : outline.sides) {
      const Side line = ordered(side);
      const auto [entry, is_new] = known.try_emplace(key_of(line));
      if (is_new) entry->second = lines.between(line[0], line[1]);
      std::vector<std::uint32_t> on = entry->second;
      if (on.empty()) {
        sides.push_back(side);
        continue;
      }
      changed = true;
      if (line != side) std::ranges::reverse(on);
      std::uint32_t at = side[0];
      for (const std::uint32_t point : on) sides.push_back({std::exchange(at, point), point});
      sides.push_back({at, side[1]});
    }
    if (!changed) continue;
    any = true;
    cancel(sides);
    outline.sides = std::move(sides);
  }
  return any;
}

void join_straight(Outlines& outlines, double tolerance) {
  const std::vector<Side> neighbours = straight_neighbours(outlines, tolerance);
  const auto is_straight = [&](std::uint32_t point) { return neighbours[point][0] != none; };
  for (Outline& outline : outlines.outlines) {
    std::vector<Side> sides;
    for (const Side& side : outline.sides) {
      if (is_straight(side[0])) continue;
      Side joined = side;
      std::uint32_t from = side[0];
      while (is_straight(joined[1])) {
        const Side& next = neighbours[joined[1]];
        from = std::exchange(joined[1], next[0] == from ? next[1] : next[0]);
      }
      sides.push_back(joined);
    }
    outline.sides = std::move(sides);
  }
}

std::optional<Side> open_side(const Outlines& outlines) {
  std::vector<Side> all;
  for (const Outline& outline : outlines.outlines) all.insert(all.end(), outline.sides.begin(), outline.sides.end());
  cancel(all);
  if (all.empty()) return std::nullopt;
  return all.front();
}

}  // namespace csgsim::software::convert
