#include "sim/software/convert/outlines.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <utility>

#include "sim/software/convert/crossings.h"
#include "sim/software/convert/exact_points.h"
#include "sim/software/convert/near_points.h"
#include "sim/software/convert/point_table.h"
#include "sim/software/convert/sets.h"
#include "sim/software/convert/sides.h"
#include "sim/software/convert/triangulate.h"

namespace csgsim::software::convert {

namespace {

/// Deviation of a corner from a straight line that rounding explains, as a fraction of the tolerance.
constexpr double straight_tolerance = 1e-3;

/// Length of an edge, relative to its largest coordinate, below which its ends become one point.
constexpr double shortest_edge = 0x1p-48;

/// What outlines of a plane are there for.
enum class Facing : std::uint8_t {
  back,   ///< the solid is before the plane
  front,  ///< the solid is behind it
  sum,    ///< of fronts, and of backs the other way: what stays is on one side only
};
constexpr std::size_t facings = 3;

/// The outlines of fragments, on exact points, and of whole bodies, on the vertices of each body.
class ExactOutlines {
 public:
  explicit ExactOutlines(const Bodies& bodies)
      : bodies_(bodies), points_(bodies.planes), numbers_(bodies.faces.size() + std::size_t{3} * WholePlanes::walls) {}

  struct Plane {
    std::uint32_t plane = 0;
    Facing facing = Facing::front;
    std::vector<Side> sides;
  };

  void add(const Fragment& fragment, Facing facing) {
    const std::size_t count = fragment.corners.size();
    round_.clear();
    for (const FragmentCorner& corner : fragment.corners) {
      const std::uint32_t point = points_.add(corner.planes);
      if (point == vertices_.size()) vertices_.push_back(nullptr);
      if (corner.vertex != no_vertex && vertices_[point] == nullptr)
        vertices_[point] = &bodies_.bodies[fragment.body].vertices[corner.vertex];
      round_.push_back(point);
    }
    std::vector<Side>& sides = sides_of(fragment.plane, facing);
    for (std::size_t i = 0; i < count; ++i) {
      const Side side{round_[i], round_[(i + 1) % count]};
      sides.push_back(side);
      lines_.try_emplace(key_of(side), std::array{fragment.plane, fragment.corners[i].along});
    }
  }

  /// Ends sides at all points that are on them, exactly. The outlines are closed then.
  void split() {
    std::vector<bool> is_used(points_.places().size(), false);
    for (Plane& outline : outlines_) {
      cancel(outline.sides);
      for (const Side& side : outline.sides) is_used[side[0]] = is_used[side[1]] = true;
    }
    const NearPoints near(points_.places(), is_used);
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> known;
    for (Plane& outline : outlines_) {
      std::vector<Side> sides;
      for (const Side& side : outline.sides) {
        const auto [entry, is_new] = known.try_emplace(key_of(side));
        if (is_new) entry->second = between({std::min(side[0], side[1]), std::max(side[0], side[1])}, near);
        end_at(side, entry->second, sides);
      }
      cancel(sides);
      outline.sides = std::move(sides);
    }
    lines_.clear();
  }

  /// The polygons of bodies that are `whole`, each body closed in itself. In planes with faces on both sides the sum of
  /// the sides stays: where one face is against another they cancel.
  void add_whole(const std::vector<bool>& whole) {
    std::vector<std::array<bool, 2>> has(bodies_.faces.size());
    const auto for_bodies = [&](const auto& what) {
      for (std::uint32_t i = 0; i < whole.size(); ++i)
        if (whole[i]) what(bodies_.bodies[i]);
    };
    for_bodies([&](const Body& body) {
      for (const BodyFace& face : body.faces) has[face.halfspace.plane][face.halfspace.positive ? 1 : 0] = true;
    });
    for_bodies([&](const Body& body) {
      const auto first = static_cast<std::uint32_t>(vertices_.size());
      for (const glm::dvec3& vertex : body.vertices) vertices_.push_back(&vertex);
      for (const BodyPolygon& polygon : body.polygons) {
        const facet::Halfspace halfspace = body.faces[polygon.face].halfspace;
        const std::array<bool, 2>& both = has[halfspace.plane];
        std::vector<Side>& sides = sides_of(halfspace.plane, both[0] && both[1]   ? Facing::sum
                                                             : halfspace.positive ? Facing::front
                                                                                  : Facing::back);
        const std::span<const std::uint32_t> corners = body.corners_of(polygon);
        for (std::size_t i = 0; i < corners.size(); ++i)
          sides.push_back({first + corners[i], first + corners[(i + 1) % corners.size()]});
      }
    });
  }

  [[nodiscard]] const std::vector<Plane>& outlines() const { return outlines_; }
  [[nodiscard]] std::size_t points() const { return vertices_.size(); }

  /// Model space; a vertex of a body where the point stands for one.
  [[nodiscard]] glm::dvec3 place(std::uint32_t point) const {
    if (vertices_[point] != nullptr) return *vertices_[point];
    return bodies_.reference + points_.places()[point] * bodies_.planes.unit();
  }
  [[nodiscard]] bool is_vertex(std::uint32_t point) const { return vertices_[point] != nullptr; }

 private:
  std::vector<Side>& sides_of(std::uint32_t plane, Facing facing) {
    std::uint32_t& number = numbers_[plane][static_cast<std::size_t>(facing)];
    if (number == 0) {
      outlines_.push_back({plane, facing, {}});
      number = static_cast<std::uint32_t>(outlines_.size());
    }
    return outlines_[number - 1].sides;
  }

  [[nodiscard]] std::vector<std::uint32_t> between(const Side& side, const NearPoints& near) const {
    const glm::dvec3 farthest = glm::max(glm::abs(points_.places()[side[0]]), glm::abs(points_.places()[side[1]]));
    const double error = 4 * error_of_place * std::max({farthest.x, farthest.y, farthest.z});
    std::vector<std::uint32_t> candidates;
    for (const PointAlong& one : near.beside(side[0], side[1], error)) candidates.push_back(one.point);
    if (candidates.empty()) return candidates;
    return points_between(bodies_.planes, points_, side[0], side[1], lines_.at(key_of(side)), candidates);
  }

  const Bodies& bodies_;
  ExactPoints points_;
  std::vector<const glm::dvec3*> vertices_;                  ///< of points that stand for one
  std::vector<std::array<std::uint32_t, facings>> numbers_;  ///< of outlines by plane and facing, from 1
  std::vector<Plane> outlines_;
  std::unordered_map<std::uint64_t, std::array<std::uint32_t, 2>> lines_;  ///< planes through sides
  std::vector<std::uint32_t> round_;
};

/// Numbers of the points that exact ones are rounded to. Outlines on exact points that are closed stay so, whatever
/// points become one.
class Rounding {
 public:
  Rounding(const Bodies& bodies, const ExactOutlines& exact)
      : exact_(exact), table_(bodies.reference, bodies.tolerance), numbers_(exact.points(), none) {
    std::vector<bool> is_used(exact.points(), false);
    for (const ExactOutlines::Plane& outline : exact.outlines())
      for (const Side& side : outline.sides) is_used[side[0]] = is_used[side[1]] = true;
    // Vertices of primitives are added first: nearby points take their coordinates.
    for (const bool is_vertex : {true, false})
      for (std::uint32_t i = 0; i < numbers_.size(); ++i)
        if (is_used[i] && exact.is_vertex(i) == is_vertex) numbers_[i] = table_.add(exact.place(i));
    join_short_edges();
  }

  [[nodiscard]] std::vector<Side> operator()(const std::vector<Side>& sides) const {
    std::vector<Side> rounded;
    rounded.reserve(sides.size());
    for (const Side& side : sides) rounded.push_back({numbers_[side[0]], numbers_[side[1]]});
    cancel(rounded);
    return rounded;
  }

  [[nodiscard]] const std::vector<glm::dvec3>& points() const { return table_.points(); }

 private:
  static constexpr std::uint32_t none = 0xffffffffU;

  void join_short_edges() {
    Sets sets(points().size());
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
  cancel(sides);
}

/// Divides what is left of the sums into fronts and backs. Whether no sides cross there.
bool divide_sums(std::span<const std::size_t> sums, Outlines& outlines) {
  for (const std::size_t sum : sums) {
    if (outlines.outlines[sum].sides.empty()) continue;
    const std::optional<TwoSides> two = two_sides(outlines.points, outlines.outlines[sum]);
    if (!two) return false;
    outlines.outlines[sum].sides.clear();
    append(outlines.outlines[sum].sides, two->front);
    Outline back{-outlines.outlines[sum].outward, {}};
    append(back.sides, two->back);
    outlines.outlines.push_back(std::move(back));
  }
  return true;
}

/// Ends sides at points that are on them, and at points where sides of the sums cross.
void end_everywhere(std::span<const std::size_t> sums, double tolerance, Outlines& outlines) {
  constexpr int most_rounds = 10;
  constexpr int most_crossing_rounds = 3;
  for (int round = 0; round < most_rounds; ++round) {
    const bool any = end_at_points(outlines, tolerance);
    const bool may_cross = round < most_crossing_rounds;
    if (!(may_cross && end_at_crossings(sums, outlines)) && !any) return;
  }
}

}  // namespace

std::optional<Outlines> join(const Bodies& bodies, const std::vector<bool>& whole,
                             const std::vector<Fragment>& fragments) {
  ExactOutlines exact(bodies);
  for (const Fragment& fragment : fragments) exact.add(fragment, fragment.is_front ? Facing::front : Facing::back);
  exact.split();
  exact.add_whole(whole);
  const Rounding rounding(bodies, exact);
  Outlines result{rounding.points(), {}};
  for (const ExactOutlines::Plane& outline : exact.outlines()) {
    const std::array<double, 4>& near = bodies.planes.near(outline.plane);
    const glm::dvec3 normal(near[0], near[1], near[2]);
    result.outlines.push_back({outline.facing == Facing::back ? -normal : normal, rounding(outline.sides)});
  }
  if (open_side(result)) throw std::logic_error("the boundary of the model is not closed");
  std::vector<std::size_t> sums;
  for (std::size_t i = 0; i < exact.outlines().size(); ++i)
    if (exact.outlines()[i].facing == Facing::sum) sums.push_back(i);
  end_everywhere(sums, bodies.tolerance, result);
  if (!divide_sums(sums, result)) return std::nullopt;
  join_straight(result, straight_tolerance * bodies.tolerance);
  std::erase_if(result.outlines, [](const Outline& outline) { return outline.sides.empty(); });
  return result;
}

}  // namespace csgsim::software::convert
