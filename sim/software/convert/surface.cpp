#include "sim/software/convert/surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>
#include <span>
#include <stdexcept>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "sim/software/convert/sets.h"

namespace csgsim::software::convert {

namespace {

constexpr std::uint32_t none = 0xffffffffU;

/// A side of a triangle.
struct HalfEdge {
  std::uint32_t low = 0;  ///< its end points
  std::uint32_t high = 0;
  std::uint32_t number = 0;  ///< three per triangle, numbered by the corner where each starts
};

/// One of several half-edges between the same two points.
struct Leaf {
  std::uint32_t number = 0;
  bool is_forward = false;  ///< from the lower to the higher end point
  double angle = 0;         ///< direction of the triangle as seen along the edge
};

std::uint32_t next_corner(std::uint32_t number) { return number % 3 == 2 ? number - 2 : number + 1; }

class Pairing {
 public:
  Pairing(const Surface& surface, const Outlines& outlines)
      : surface_(surface), outlines_(outlines), others_(3 * surface.triangles.size(), none) {}

  /// The partner of each half-edge.
  std::vector<std::uint32_t> operator()() {
    std::vector<HalfEdge> edges;
    edges.reserve(others_.size());
    for (std::uint32_t i = 0; i < others_.size(); ++i) {
      const std::uint32_t from = surface_.triangles[i / 3][i % 3];
      const std::uint32_t to = surface_.triangles[i / 3][(i + 1) % 3];
      edges.push_back({std::min(from, to), std::max(from, to), i});
    }
    std::ranges::sort(edges, {}, [](const HalfEdge& edge) { return std::tuple(edge.low, edge.high, edge.number); });
    for (auto begin = edges.begin(); begin != edges.end();) {
      const auto end = std::find_if(
          begin, edges.end(), [&](const HalfEdge& edge) { return edge.low != begin->low || edge.high != begin->high; });
      pair({begin, end});
      begin = end;
    }
    return std::move(others_);
  }

 private:
  void join(std::uint32_t one, std::uint32_t other) {
    others_[one] = other;
    others_[other] = one;
  }

  [[nodiscard]] bool is_forward(const HalfEdge& edge) const {
    return surface_.triangles[edge.number / 3][edge.number % 3] == edge.low;
  }

  /// Pairs half-edges around an edge: each triangle that runs forward with the next one that runs back, clockwise
  /// through the solid.
  void pair(std::span<const HalfEdge> edges) {
    const auto forward = std::ranges::count_if(edges, [&](const HalfEdge& edge) { return is_forward(edge); });
    if (2 * forward != static_cast<std::ptrdiff_t>(edges.size()))
      throw std::logic_error("the boundary of the model is not closed");
    if (edges.size() == 2) {
      join(edges[0].number, edges[1].number);
      return;
    }
    const std::vector<Leaf> leaves = leaves_around(edges);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < 2 * leaves.size(); ++i) {
      const std::size_t at = i % leaves.size();
      if (others_[leaves[at].number] != none) continue;
      if (leaves[at].is_forward) {
        open.push_back(at);
      } else if (!open.empty()) {
        join(leaves[open.back()].number, leaves[at].number);
        open.pop_back();
      }
    }
  }

  /// The leaves sorted around the edge.
  [[nodiscard]] std::vector<Leaf> leaves_around(std::span<const HalfEdge> edges) const {
    std::vector<Leaf> leaves;
    leaves.reserve(edges.size());
    for (const HalfEdge& edge : edges) leaves.push_back({edge.number, is_forward(edge), 0});
    const glm::dvec3 way = outlines_.points[edges.front().high] - outlines_.points[edges.front().low];
    if (way != glm::dvec3(0)) find_angles(glm::normalize(way), leaves);  // otherwise all pairings are equivalent
    std::ranges::sort(leaves, [](const Leaf& one, const Leaf& other) {
      return one.angle != other.angle ? one.angle > other.angle : one.is_forward > other.is_forward;
    });
    return leaves;
  }

  void find_angles(const glm::dvec3& along, std::span<Leaf> leaves) const {
    glm::dvec3 across(0);
    for (Leaf& leaf : leaves) {
      const glm::dvec3 outward = outlines_.outlines[surface_.outlines[leaf.number / 3]].outward;
      const glm::dvec3 inwards = leaf.is_forward ? glm::cross(outward, along) : glm::cross(along, outward);
      if (across == glm::dvec3(0)) across = inwards;
      leaf.angle = std::atan2(glm::dot(glm::cross(across, inwards), along), glm::dot(across, inwards));
    }
  }

  const Surface& surface_;
  const Outlines& outlines_;
  std::vector<std::uint32_t> others_;
};

/// Corners connected along edges share a point; others are separated.
void part_points(Surface& surface, const std::vector<std::uint32_t>& others) {
  DisjointSets corners(others.size());
  for (std::uint32_t i = 0; i < others.size(); ++i) {
    corners.join(i, next_corner(others[i]));
    corners.join(next_corner(i), others[i]);
  }
  std::vector<std::uint32_t> numbers(others.size(), none);
  std::vector<glm::dvec3> points;
  for (std::uint32_t i = 0; i < others.size(); ++i) {
    std::uint32_t& number = numbers[corners.find(i)];
    std::uint32_t& corner = surface.triangles[i / 3][i % 3];
    if (number == none) {
      number = static_cast<std::uint32_t>(points.size());
      points.push_back(surface.points[corner]);
    }
    corner = number;
  }
  surface.points = std::move(points);
}

/// Removes pairs of opposite triangles on the same three points.
void cancel_triangles(Surface& surface) {
  struct Standing {
    Triangle corners{};  ///< ascending
    std::uint32_t number = 0;
    bool is_even = false;  ///< whether the sorted order is an even permutation
  };
  std::vector<Standing> standing;
  standing.reserve(surface.triangles.size());
  for (std::uint32_t i = 0; i < surface.triangles.size(); ++i) {
    Standing one{surface.triangles[i], i, true};
    std::rotate(one.corners.begin(), std::ranges::min_element(one.corners), one.corners.end());
    if (one.corners[1] > one.corners[2]) {
      std::swap(one.corners[1], one.corners[2]);
      one.is_even = false;
    }
    standing.push_back(one);
  }
  std::ranges::sort(standing, {}, [](const Standing& one) { return std::tuple(one.corners, one.is_even, one.number); });
  std::vector<bool> is_out(surface.triangles.size(), false);
  bool any = false;
  for (auto begin = standing.begin(); begin != standing.end();) {
    const auto end =
        std::find_if(begin, standing.end(), [&](const Standing& one) { return one.corners != begin->corners; });
    const auto even = std::find_if(begin, end, [](const Standing& one) { return one.is_even; });
    for (std::ptrdiff_t i = 0; i < std::min(even - begin, end - even); ++i)
      is_out[begin[i].number] = is_out[even[i].number] = any = true;
    begin = end;
  }
  if (!any) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < surface.triangles.size(); ++i) {
    if (is_out[i]) continue;
    surface.triangles[kept] = surface.triangles[i];
    surface.outlines[kept++] = surface.outlines[i];
  }
  surface.triangles.resize(kept);
  surface.outlines.resize(kept);
}

/// Splits edges of a surface with paired half-edges.
class Halving {
 public:
  Halving(Surface& surface, std::vector<std::uint32_t>& others) : surface_(surface), others_(others) {}

  /// Inserts a point in the middle of each edge that connects the same points as another edge, which occurs if a solid
  /// touches itself along an edge and is connected at both ends.
  void operator()() {
    std::vector<std::pair<Side, std::uint32_t>> edges;
    for (std::uint32_t i = 0; i < others_.size(); ++i) edges.emplace_back(Side{corner(i), corner(next_corner(i))}, i);
    std::ranges::sort(edges);
    std::vector<std::uint32_t> repeated;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const bool is_repeated = (i > 0 && edges[i - 1].first == edges[i].first) ||
                               (i + 1 < edges.size() && edges[i + 1].first == edges[i].first);
      if (is_repeated && edges[i].first[0] < edges[i].first[1]) repeated.push_back(edges[i].second);
    }
    for (std::uint32_t edge : repeated) {
      for (auto moved = moved_.find(edge); moved != moved_.end(); moved = moved_.find(edge)) edge = moved->second;
      halve(edge);
    }
  }

 private:
  std::uint32_t& corner(std::uint32_t half_edge) { return surface_.triangles[half_edge / 3][half_edge % 3]; }

  void join(std::uint32_t one, std::uint32_t other) {
    others_[one] = other;
    others_[other] = one;
  }

  /// Splits a triangle at the middle of a half-edge. Returns the half-edge of the second part, which starts at the
  /// middle.
  std::uint32_t cut(std::uint32_t half_edge, std::uint32_t middle) {
    const std::uint32_t after = next_corner(half_edge);
    const auto first = static_cast<std::uint32_t>(others_.size());
    surface_.triangles.push_back({middle, corner(after), corner(next_corner(after))});
    surface_.outlines.push_back(surface_.outlines[half_edge / 3]);
    others_.resize(others_.size() + 3);
    join(first + 1, others_[after]);
    join(first + 2, after);
    moved_.try_emplace(after, first + 1);
    corner(after) = middle;
    return first;
  }

  void halve(std::uint32_t half_edge) {
    const std::uint32_t back = others_[half_edge];
    const glm::dvec3 middle = (surface_.points[corner(half_edge)] + surface_.points[corner(back)]) / 2.0;
    const auto point = static_cast<std::uint32_t>(surface_.points.size());
    surface_.points.push_back(middle);
    const std::uint32_t rest = cut(half_edge, point);
    const std::uint32_t rest_back = cut(back, point);
    join(half_edge, rest_back);
    join(back, rest);
  }

  Surface& surface_;
  std::vector<std::uint32_t>& others_;
  std::unordered_map<std::uint32_t, std::uint32_t> moved_;  ///< new index of half-edges that were renumbered
};

/// Restores the order of Surface::outlines.
void sort_by_outlines(Surface& surface) {
  std::vector<std::uint32_t> order(surface.triangles.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&](std::uint32_t triangle) { return surface.outlines[triangle]; });
  Surface sorted{std::move(surface.points), {}, {}};
  for (const std::uint32_t triangle : order) {
    sorted.triangles.push_back(surface.triangles[triangle]);
    sorted.outlines.push_back(surface.outlines[triangle]);
  }
  surface = std::move(sorted);
}

using LongVector = glm::vec<3, long double>;

/// The cross product of the two shortest sides: with two long sides of a needle, rounding would destroy the area.
LongVector twice_area(const Surface& surface, const Triangle& triangle) {
  std::array<LongVector, 3> sides;
  for (std::size_t i = 0; i < 3; ++i)
    sides[i] = LongVector(surface.points[triangle[(i + 1) % 3]]) - LongVector(surface.points[triangle[i]]);
  std::size_t longest = 0;
  for (std::size_t i = 1; i < 3; ++i)
    if (glm::dot(sides[i], sides[i]) > glm::dot(sides[longest], sides[longest])) longest = i;
  return glm::cross(sides[(longest + 1) % 3], sides[(longest + 2) % 3]);
}

}  // namespace

Surface make_surface(const Outlines& outlines) {
  Surface surface{outlines.points, {}, {}};
  for (std::uint32_t i = 0; i < outlines.outlines.size(); ++i) {
    const std::vector<Triangle> triangles = triangulate(outlines.points, outlines.outlines[i]);
    surface.triangles.insert(surface.triangles.end(), triangles.begin(), triangles.end());
    surface.outlines.resize(surface.triangles.size(), i);
  }
  cancel_triangles(surface);
  std::vector<std::uint32_t> others = Pairing(surface, outlines)();
  part_points(surface, others);
  const std::size_t before = surface.triangles.size();
  Halving(surface, others)();
  if (surface.triangles.size() != before) sort_by_outlines(surface);
  return surface;
}

namespace {

/// Upper bound of the effect of rounding on the volume behind a triangle: its projected area along each axis times half
/// a unit in the last place of the largest coordinate on that axis.
double volume_error(const Surface& surface, const Triangle& triangle, const LongVector& twice_area) {
  constexpr double half_unit = 0x1p-53;
  double sum = 0;
  for (int axis = 0; axis < 3; ++axis) {
    double farthest = 0;
    for (const std::uint32_t corner : triangle) farthest = std::max(farthest, std::abs(surface.points[corner][axis]));
    sum += std::abs(static_cast<double>(twice_area[axis])) / 2 * half_unit * farthest;
  }
  return sum;
}

}  // namespace

Measures measure(const Surface& surface) {
  Measures measures;
  DisjointSets points(surface.points.size());
  for (const Triangle& triangle : surface.triangles) {
    points.join(triangle[0], triangle[1]);
    points.join(triangle[1], triangle[2]);
  }
  long double volume = 0;
  for (const Triangle& triangle : surface.triangles) {
    // Relative to a point of the shell, because a distant origin would cost precision.
    const glm::dvec3& origin = surface.points[points.find(triangle[0])];
    const LongVector area = twice_area(surface, triangle);
    volume += glm::dot(LongVector(surface.points[triangle[0]]) - LongVector(origin), area) / 6;
    measures.area += static_cast<double>(glm::length(area)) / 2.0;
    measures.volume_error += volume_error(surface, triangle, area);
  }
  measures.volume = static_cast<double>(volume);
  for (std::uint32_t i = 0; i < surface.points.size(); ++i)
    if (points.find(i) == i) ++measures.shells;
  const auto triangles = static_cast<std::int64_t>(surface.triangles.size());
  measures.euler = static_cast<std::int64_t>(surface.points.size()) - triangles / 2;
  return measures;
}

}  // namespace csgsim::software::convert
