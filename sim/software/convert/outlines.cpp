#include "sim/software/convert/outlines.h"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>

#include "host/convex/clip.h"
#include "sim/software/convert/point_table.h"
#include "sim/software/convert/sides.h"
#include "sim/software/convert/triangulate.h"

namespace csgsim::software::convert {

namespace {

/// As a part of the diagonal: what is left of places that were rounded.
constexpr double straight_tolerance = 1e-13;

struct TripleHash {
  std::size_t operator()(const Triple& triple) const {
    std::uint64_t sum = 0;
    for (const std::uint32_t one : triple) {
      sum = (sum ^ one) * 0x9e3779b97f4a7c15U;
      sum ^= sum >> 32U;
    }
    return sum;
  }
};

/// Numbers of the points of fragments.
class Points {
 public:
  explicit Points(const Bodies& bodies)
      : centre_(bodies.geometry.planes.centre()),
        unit_(bodies.planes.unit()),
        table_(bodies.geometry.planes.centre(), bodies.geometry.planes.diagonal()) {
    // Where a corner of a primitive is near, it is the point.
    for (const facet::Convex& solid : bodies.geometry.solids) {
      first_.push_back(vertices_.size());
      for (const glm::dvec3& vertex : solid.vertices) vertices_.push_back(table_.add(vertex));
    }
  }

  /// Of a body's vertex.
  [[nodiscard]] std::uint32_t number_of(std::size_t body, std::uint32_t vertex) const {
    return vertices_[first_[body] + vertex];
  }

  std::uint32_t number_of(const FragmentCorner& corner) {
    const auto [entry, is_new] = known_.try_emplace(corner.planes, 0);
    if (is_new) entry->second = table_.add(centre_ + corner.place * unit_);
    return entry->second;
  }

  [[nodiscard]] const std::vector<glm::dvec3>& all() const { return table_.points(); }

 private:
  glm::dvec3 centre_;
  double unit_;
  PointTable table_;
  std::vector<std::size_t> first_;       ///< of each body's vertices
  std::vector<std::uint32_t> vertices_;  ///< numbers of their points
  std::unordered_map<Triple, std::uint32_t, TripleHash> known_;
};

/// Gathers outlines by their planes.
class Gathering {
 public:
  explicit Gathering(const Bodies& bodies)
      : bodies_(bodies), points_(bodies), numbers_(bodies.geometry.planes.planes().size()) {}

  void add(const Fragment& fragment) {
    round_.clear();
    for (const FragmentCorner& corner : fragment.corners) round_.push_back(points_.number_of(corner));
    if (fragment.polygon != nullptr) add_polygon(fragment);
    add_round(sides_of(fragment.plane, fragment.is_front ? front : back));
  }

  /// In planes with faces on both sides the sum of the sides stays: where one face is against another they cancel.
  void add_whole(const std::vector<bool>& whole) {
    std::vector<std::array<bool, 2>> has(numbers_.size());
    for_faces(whole, [&](const facet::Halfspace& halfspace, std::size_t, const BodyPolygon&) {
      has[halfspace.plane][halfspace.positive ? front : back] = true;
    });
    for_faces(whole, [&](const facet::Halfspace& halfspace, std::size_t body, const BodyPolygon& polygon) {
      const std::array<bool, 2>& both = has[halfspace.plane];
      round_.clear();
      for (const std::uint32_t corner : polygon.corners) round_.push_back(points_.number_of(body, corner));
      add_round(sides_of(halfspace.plane, both[0] && both[1] ? sum : halfspace.positive ? front : back));
    });
  }

  Outlines& outlines() {
    result_.points = points_.all();
    return result_;
  }

  /// Divides what is left of the sums into fronts and backs. Whether no sides cross there.
  bool divide_sums() {
    for (std::uint32_t plane = 0; plane < numbers_.size(); ++plane) {
      const std::uint32_t number = numbers_[plane][sum];
      if (number == 0 || result_.outlines[number - 1].sides.empty()) continue;
      const std::optional<TwoSides> two = two_sides(result_.points, result_.outlines[number - 1]);
      if (!two) return false;
      result_.outlines[number - 1].sides.clear();
      append(sides_of(plane, front), two->front);
      append(sides_of(plane, back), two->back);
    }
    return true;
  }

 private:
  static constexpr std::size_t back = 0;
  static constexpr std::size_t front = 1;
  static constexpr std::size_t sum = 2;  ///< of fronts, and of backs the other way

  void add_polygon(const Fragment& fragment) {
    const Body& body = bodies_.bodies[fragment.body];
    for (const std::uint32_t corner : fragment.polygon->corners)
      round_.push_back(points_.number_of(fragment.body, corner));
    if (body.faces[fragment.polygon->face].halfspace.positive != fragment.is_front) std::ranges::reverse(round_);
  }

  template <class Do>
  void for_faces(const std::vector<bool>& whole, const Do& what) const {
    for (std::size_t i = 0; i < whole.size(); ++i) {
      if (!whole[i]) continue;
      const Body& body = bodies_.bodies[i];
      for (const BodyPolygon& polygon : body.polygons) what(body.faces[polygon.face].halfspace, i, polygon);
    }
  }

  std::vector<Side>& sides_of(std::uint32_t plane, std::size_t kind) {
    std::uint32_t& number = numbers_[plane][kind];
    if (number == 0) {
      const glm::dvec3 normal = bodies_.geometry.planes.planes()[plane].normal;
      result_.outlines.push_back({kind == back ? -normal : normal, {}});
      number = static_cast<std::uint32_t>(result_.outlines.size());
    }
    return result_.outlines[number - 1].sides;
  }

  void add_round(std::vector<Side>& sides) const {
    for (std::size_t i = 0; i < round_.size(); ++i) sides.push_back({round_[i], round_[(i + 1) % round_.size()]});
  }

  static void append(std::vector<Side>& sides, const std::vector<Triangle>& triangles) {
    if (triangles.empty()) return;
    for (const Triangle& triangle : triangles)
      for (std::size_t i = 0; i < 3; ++i) sides.push_back({triangle[i], triangle[(i + 1) % 3]});
    cancel(sides);
  }

  const Bodies& bodies_;
  Points points_;
  std::vector<std::array<std::uint32_t, 3>> numbers_;  ///< of outlines by plane and kind, from 1
  std::vector<std::uint32_t> round_;
  Outlines result_;
};

}  // namespace

std::optional<Outlines> join(const Bodies& bodies, const std::vector<bool>& whole,
                             const std::vector<Fragment>& fragments) {
  Gathering gathering(bodies);
  for (const Fragment& fragment : fragments) gathering.add(fragment);
  gathering.add_whole(whole);
  Outlines& result = gathering.outlines();
  for (Outline& outline : result.outlines) cancel(outline.sides);
  constexpr int most_rounds = 10;
  const facet::PlaneTable& planes = bodies.geometry.planes;
  const double tolerance = convex::tolerance(planes);
  for (int round = 0; round < most_rounds && end_at_points(result, tolerance); ++round) {
  }
  if (open_side(result) || !gathering.divide_sums()) return std::nullopt;
  join_straight(result, straight_tolerance * planes.diagonal());
  std::erase_if(result.outlines, [](const Outline& outline) { return outline.sides.empty(); });
  return std::move(result);
}

}  // namespace csgsim::software::convert
