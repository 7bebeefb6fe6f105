#include "sim/software/convert/outlines.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <utility>

#include "sim/software/convert/crossings.h"
#include "sim/software/convert/near_points.h"
#include "sim/software/convert/point_table.h"
#include "sim/software/convert/sets.h"
#include "sim/software/convert/sides.h"
#include "sim/software/convert/triangulate.h"

namespace csgsim::software::convert {

namespace {

/// Maximum deviation of a corner from a straight line due to rounding, relative to the tolerance.
constexpr double straight_tolerance = 1e-3;

/// Length of an edge, relative to its largest coordinate, up to which its ends are merged.
constexpr double shortest_edge = 0x1p-48;

/// Indices of the points that exact points are rounded to. Closed outlines stay closed, regardless of the points that
/// are merged.
class Rounding {
 public:
  Rounding(const Bodies& bodies, const ExactOutlines& exact)
      : exact_(exact), table_(bodies.reference, bodies.tolerance), numbers_(exact.point_count(), none) {
    std::vector<bool> is_used(exact.point_count(), false);
    for (const ExactOutlines::Plane& outline : exact.outlines())
      for (const Side& side : outline.sides) is_used[side[0]] = is_used[side[1]] = true;
    // Vertices of primitives are added first, so that nearby points take their coordinates.
    for (const bool is_vertex : {true, false})
      for (std::uint32_t i = 0; i < numbers_.size(); ++i)
        if (is_used[i] && exact.is_vertex(i) == is_vertex) numbers_[i] = table_.add(exact.place(i));
    join_short_edges();
  }

  [[nodiscard]] std::vector<Side> operator()(const std::vector<Side>& sides) const {
    std::vector<Side> rounded;
    rounded.reserve(sides.size());
    for (const Side& side : sides) rounded.push_back({numbers_[side[0]], numbers_[side[1]]});
    cancel_opposite_sides(rounded);
    return rounded;
  }

  [[nodiscard]] const std::vector<glm::dvec3>& points() const { return table_.points(); }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  void join_short_edges() {
    DisjointSets sets(points().size());
    for (const ExactOutlines::Plane& outline : exact_.outlines()) {
      for (const Side& side : outline.sides) {
        const glm::dvec3& one = points()[numbers_[side[0]]];
        const glm::dvec3& other = points()[numbers_[side[1]]];
        const glm::dvec3 farthest = glm::max(glm::abs(one), glm::abs(other));
        if (glm::distance(one, other) <= shortest_edge * std::max({farthest.x, farthest.y, farthest.z}))
          sets.join(numbers_[side[0]], numbers_[side[1]]);
      }
    }
    for (std::uint32_t& number : numbers_)
      if (number != none) number = sets.find(number);
  }

  const ExactOutlines& exact_;
  PointTable table_;
  std::vector<std::uint32_t> numbers_;
};

void append(std::vector<Side>& sides, const std::vector<Triangle>& triangles) {
  for (const Triangle& triangle : triangles)
    for (std::size_t i = 0; i < 3; ++i) sides.push_back({triangle[i], triangle[(i + 1) % 3]});
  cancel_opposite_sides(sides);
}

/// Divides the remaining sums into fronts and backs. Returns false if sides cross.
bool divide_sums(std::span<const std::size_t> sums, Outlines& outlines) {
  for (const std::size_t sum : sums) {
    if (outlines.outlines[sum].sides.empty()) continue;
    const std::optional<TwoSidedTriangles> two = triangulate_two_sided(outlines.points, outlines.outlines[sum]);
    if (!two) return false;
    outlines.outlines[sum].sides.clear();
    append(outlines.outlines[sum].sides, two->front);
    Outline back{-outlines.outlines[sum].outward, {}};
    append(back.sides, two->back);
    outlines.outlines.push_back(std::move(back));
  }
  return true;
}

std::vector<std::size_t> all_of(const Outlines& outlines) {
  std::vector<std::size_t> all(outlines.outlines.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

NearPoints used_points(const Outlines& outlines) {
  std::vector<bool> is_used(outlines.points.size(), false);
  for (const Outline& outline : outlines.outlines)
    for (const Side& side : outline.sides) is_used[side[0]] = is_used[side[1]] = true;
  std::vector<std::uint32_t> used;
  for (std::uint32_t i = 0; i < is_used.size(); ++i)
    if (is_used[i]) used.push_back(i);
  return {outlines.points, used};
}

/// Splits sides at points that lie on them.
void split_at_all_points(double tolerance, Outlines& outlines) {
  constexpr int max_rounds = 10;
  const NearPoints near = used_points(outlines);
  std::vector<std::size_t> changed = all_of(outlines);
  for (int round = 0; round < max_rounds && !changed.empty(); ++round)
    changed = split_at_points(changed, near, tolerance, outlines);
}

/// Splits sides at points that lie on them, and at intersections of sides of the sums.
void end_everywhere(std::span<const std::size_t> sums, double tolerance, Outlines& outlines) {
  constexpr int max_crossing_rounds = 3;
  split_at_all_points(tolerance, outlines);
  for (int round = 0; round < max_crossing_rounds && try_split_at_crossings(sums, outlines); ++round)
    split_at_all_points(tolerance, outlines);
}

}  // namespace

std::optional<Outlines> join(const Bodies& bodies, ExactOutlines exact) {
  Outlines result;
  std::vector<std::size_t> sums;
  {
    const ExactOutlines taken = std::move(exact);  // released before the following steps to save memory
    const Rounding rounding(bodies, taken);
    result.points = rounding.points();
    for (const ExactOutlines::Plane& outline : taken.outlines()) {
      if (outline.facing == Facing::sum) sums.push_back(result.outlines.size());
      const std::array<double, 4>& near = bodies.planes.coefficients(outline.plane);
      const glm::dvec3 normal(near[0], near[1], near[2]);
      result.outlines.push_back({outline.facing == Facing::back ? -normal : normal, rounding(outline.sides)});
    }
  }
  if (open_side(result)) throw std::logic_error("the boundary of the model is not closed");
  end_everywhere(sums, bodies.tolerance, result);
  if (!divide_sums(sums, result)) return std::nullopt;
  join_straight(result, straight_tolerance * bodies.tolerance);
  std::erase_if(result.outlines, [](const Outline& outline) { return outline.sides.empty(); });
  return result;
}

}  // namespace csgsim::software::convert
