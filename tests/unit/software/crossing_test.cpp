#include <rapidcheck.h>

#include <boost/multiprecision/cpp_int.hpp>

#include "sim/software/planes/sheet.h"
#include "sim/software/planes/whole_planes.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"

using namespace csgsim;
using software::Region;
using software::Sheet;
using software::WholePlanes;

namespace {

using Rational = boost::multiprecision::cpp_rational;
using RationalPoint = std::array<Rational, 3>;
using RationalPolygon = std::vector<RationalPoint>;

/// A convex polygon in one of several planes, bounded by half-spaces of others.
struct Polygon {
  std::uint32_t plane = 0;
  std::vector<facet::Halfspace> bounds;
};

/// Judge: planes as rational numbers, polygons as their corners.
class Judge {
 public:
  explicit Judge(const WholePlanes& planes) : planes_(planes) {}

  [[nodiscard]] Rational height(const RationalPoint& point, std::uint32_t plane) const {
    const std::array<double, 4>& row = planes_.coefficients(plane);
    return Rational(row[0]) * point[0] + Rational(row[1]) * point[1] + Rational(row[2]) * point[2] + Rational(row[3]);
  }

  /// A square of the plane as large as the walls, clipped by the bounds.
  [[nodiscard]] RationalPolygon corners_of(const Polygon& polygon) const {
    const std::array<double, 4>& row = planes_.coefficients(polygon.plane);
    std::size_t axis = 0;
    for (std::size_t i = 1; i < 3; ++i) {
      if (std::abs(row[i]) > std::abs(row[axis])) axis = i;
    }
    RationalPolygon corners;
    for (const auto& [u, v] : {std::array{-3, -3}, std::array{3, -3}, std::array{3, 3}, std::array{-3, 3}}) {
      RationalPoint corner;
      corner[(axis + 1) % 3] = Rational(u, 4);
      corner[(axis + 2) % 3] = Rational(v, 4);
      corner[axis] = -(Rational(row[(axis + 1) % 3]) * corner[(axis + 1) % 3] +
                       Rational(row[(axis + 2) % 3]) * corner[(axis + 2) % 3] + Rational(row[3])) /
                     Rational(row[axis]);
      corners.push_back(corner);
    }
    for (const facet::Halfspace& bound : polygon.bounds) corners = clipped(corners, bound);
    return corners;
  }

  [[nodiscard]] RationalPolygon clipped(const RationalPolygon& corners, facet::Halfspace bound) const {
    RationalPolygon left;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const RationalPoint& from = corners[i];
      const RationalPoint& to = corners[(i + 1) % corners.size()];
      const Rational here = bound.positive ? height(from, bound.plane) : Rational(-height(from, bound.plane));
      const Rational there = bound.positive ? height(to, bound.plane) : Rational(-height(to, bound.plane));
      if (here <= 0) left.push_back(from);
      if ((here < 0 && there > 0) || (here > 0 && there < 0)) {
        const Rational part = here / (here - there);
        left.push_back({from[0] + (to[0] - from[0]) * part, from[1] + (to[1] - from[1]) * part,
                        from[2] + (to[2] - from[2]) * part});
      }
    }
    return left;
  }

  /// Whether corners are on both sides of the plane.
  [[nodiscard]] bool passes_through(std::uint32_t plane, const RationalPolygon& corners) const {
    bool is_above = false;
    bool is_below = false;
    for (const RationalPoint& corner : corners) {
      is_above = is_above || height(corner, plane) > 0;
      is_below = is_below || height(corner, plane) < 0;
    }
    return is_above && is_below;
  }

  /// Whether the part of one polygon strictly within the other's bounds is on both sides of the other's plane.
  [[nodiscard]] bool cross(const Polygon& one, const Polygon& other) const {
    RationalPolygon within = corners_of(one);
    for (const facet::Halfspace& bound : other.bounds) within = clipped(within, bound);
    for (const facet::Halfspace& bound : other.bounds) {
      const auto is_on = [&](const RationalPoint& corner) { return height(corner, bound.plane) == 0; };
      if (std::all_of(within.begin(), within.end(), is_on)) return false;
    }
    return passes_through(other.plane, within);
  }

 private:
  const WholePlanes& planes_;
};

constexpr std::uint32_t hostile = 14;

/// Planes of few directions and offsets, so that many meet in one point or line; in part with tiny offsets.
facet::PlaneTable hostile_planes(testing::Random& random) {
  facet::PlaneTable table(glm::dvec3(0), 16);
  const auto quarter = [&] { return (static_cast<double>(random.below(9)) - 4) / 4; };
  while (table.planes().size() < hostile) {
    facet::Plane plane{{quarter(), quarter(), quarter()}, quarter() * 2};
    if (random.below(3) == 0) plane.normal = {random.below(3) == 0 ? 1 : 0, random.below(2) == 0 ? 1 : 0, 0};
    if (random.below(3) == 0) {
      plane.normal += glm::dvec3(1, 3, -2) * 0x1p-40;
      plane.offset += 0x1p-41;
    }
    if (random.below(4) == 0) plane.normal = glm::normalize(glm::dvec3(quarter() + 0.1, quarter(), quarter() - 0.3));
    if (glm::length(plane.normal) > 0.2 && glm::length(plane.normal) <= 1) table.add(plane);
  }
  return table;
}

/// Whether two planes are the same set of points, whatever their coefficients' scale.
bool coincide(const WholePlanes& planes, std::uint32_t a, std::uint32_t b) {
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (Rational(planes.coefficients(a)[i]) * Rational(planes.coefficients(b)[j]) !=
          Rational(planes.coefficients(a)[j]) * Rational(planes.coefficients(b)[i]))
        return false;
    }
  }
  return true;
}

/// A random polygon bounded by planes other than its own.
Polygon any_polygon(testing::Random& random, const WholePlanes& planes) {
  Polygon polygon{static_cast<std::uint32_t>(random.below(hostile)), {}};
  for (std::uint64_t i = 2 + random.below(5); i > 0; --i) {
    const auto bound = static_cast<std::uint32_t>(random.below(hostile));
    if (!coincide(planes, bound, polygon.plane)) polygon.bounds.push_back({bound, random.below(2) == 0});
  }
  return polygon;
}

struct Pairs {
  std::uint64_t all = 0;
  std::uint64_t crossing = 0;
  std::uint64_t touching = 0;  ///< not crossing, but with corners on the other's plane
};

/// Returns the fault of a pair; empty if none. Compares the parts of both after cutting.
std::string find_fault(const WholePlanes& planes, Polygon one, Polygon other, Pairs& pairs) {
  for (Polygon* const polygon : {&one, &other}) {
    for (int axis = 0; axis < 3; ++axis) {
      polygon->bounds.push_back({planes.wall(axis, 0), false});
      polygon->bounds.push_back({planes.wall(axis, WholePlanes::walls - 1), true});
    }
  }
  const Judge judge(planes);
  Sheet of_one(planes);
  Sheet of_other(planes);
  const auto region_of = [](Sheet& sheet, const Polygon& polygon) {
    Region region = sheet.begin(polygon.plane);
    for (const facet::Halfspace& bound : polygon.bounds) {
      if (!region.empty()) region = sheet.clip(region, bound);
    }
    return region;
  };
  const Region a = region_of(of_one, one);
  const Region b = region_of(of_other, other);
  if (a.empty() || b.empty()) return "";
  ++pairs.all;
  const auto do_cross = [&](const Region& first, const Region& second) {
    const auto on_first = of_one.chord(first, other.plane);
    const auto on_second = of_other.chord(second, one.plane);
    return on_first && on_second && overlap(planes, *on_first, *on_second) && overlap(planes, *on_second, *on_first);
  };
  const bool expected = judge.cross(one, other);
  pairs.crossing += expected ? 1U : 0U;
  for (const RationalPoint& corner : judge.corners_of(one)) {
    if (!expected && one.plane != other.plane && judge.height(corner, other.plane) == 0) {
      ++pairs.touching;
      break;
    }
  }
  if (do_cross(a, b) != expected) return expected ? "they cross, unnoticed" : "they do not cross";
  if (!expected) return "";
  const software::Parts first = of_one.cut(a, {other.plane, true});
  const software::Parts second = of_other.cut(b, {one.plane, true});
  if (first.in.empty() || first.out.empty() || second.in.empty() || second.out.empty()) return "a cut leaves nothing";
  for (const Region* const part : {&first.in, &first.out}) {
    for (const Region* const part_of_other : {&second.in, &second.out}) {
      if (do_cross(*part, *part_of_other)) return "parts cross that were cut by each other's planes";
    }
  }
  return "";
}

}  // namespace

TEST_CASE("polygon crossings equal those in rational arithmetic in degenerate cases") {
  Pairs pairs;
  CHECK(rc::check([&] {
    testing::Random random(*rc::gen::arbitrary<std::uint64_t>());
    const WholePlanes planes(hostile_planes(random));
    for (unsigned i = 0; i < 60; ++i) {
      const Polygon one = any_polygon(random, planes);
      const Polygon other = any_polygon(random, planes);
      const std::string fault = find_fault(planes, one, other, pairs);
      if (!fault.empty()) RC_FAIL(fault);
    }
  }));
  MESSAGE(pairs.all, " pairs, ", pairs.crossing, " cross, ", pairs.touching, " touch");
  if (testing::draws_usual_cases()) {
    CHECK(pairs.crossing > pairs.all / 20);
    CHECK(pairs.touching > pairs.all / 100);
  }
}

namespace {

/// Planes x, y, z = i / 4 for i from -4 to 4: x = 1/4 is plane 5, y = 1/4 plane 14, z = 1/4 plane 23; additional planes
/// follow.
class Lattice {
 public:
  explicit Lattice(const std::vector<facet::Plane>& more = {}) {
    for (int axis = 0; axis < 3; ++axis) {
      for (int i = -4; i <= 4; ++i) {
        facet::Plane plane{glm::dvec3(0), -i / 4.0};
        plane.normal[axis] = 1;
        REQUIRE(table_.add(plane).plane == number(axis, i));
      }
    }
    for (const facet::Plane& plane : more) table_.add(plane);
  }

  static std::uint32_t number(int axis, int quarters) { return static_cast<std::uint32_t>(9 * axis + quarters + 4); }

  /// A rectangle across an axis, from `low` to `high` along the next two, in quarters.
  static Polygon rectangle(int axis, int at, std::array<int, 2> low, std::array<int, 2> high) {
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    return {number(axis, at),
            {{number(u, low[0]), false},
             {number(u, high[0]), true},
             {number(v, low[1]), false},
             {number(v, high[1]), true}}};
  }

  [[nodiscard]] bool cross(const Polygon& one, const Polygon& other) const {
    const WholePlanes planes(table_);
    Pairs pairs;
    CHECK(find_fault(planes, one, other, pairs) == "");
    CHECK(pairs.all == 1);
    return pairs.crossing == 1;
  }

 private:
  facet::PlaneTable table_{glm::dvec3(0), 2};
};

}  // namespace

TEST_CASE("polygons that touch or share an edge or corner or plane do not cross") {
  const Lattice lattice;
  const Polygon floor = Lattice::rectangle(2, 0, {-2, -2}, {2, 2});
  // Upright rectangles: one passes through the floor, one ends on it, and one is beside it.
  CHECK(lattice.cross(floor, Lattice::rectangle(0, 0, {-1, -1}, {1, 1})));
  CHECK(!lattice.cross(floor, Lattice::rectangle(0, 0, {-1, 0}, {1, 1})));
  CHECK(!lattice.cross(floor, Lattice::rectangle(0, 0, {2, -1}, {3, 1})));
  CHECK(!lattice.cross(floor, Lattice::rectangle(0, 2, {-2, 0}, {2, 2})));
  CHECK(!lattice.cross(floor, Lattice::rectangle(0, 2, {-1, -1}, {1, 1})));
  CHECK(lattice.cross(floor, Lattice::rectangle(0, 1, {1, -1}, {3, 1})));
  CHECK(!lattice.cross(floor, Lattice::rectangle(0, 2, {2, 0}, {3, 1})));
  CHECK(!lattice.cross(floor, floor));
  CHECK(!lattice.cross(floor, Lattice::rectangle(2, 0, {0, 0}, {3, 3})));
  CHECK(!lattice.cross(floor, Lattice::rectangle(2, 1, {-2, -2}, {2, 2})));
}

TEST_CASE("sliver polygons cross however little they extend beyond a plane") {
  for (const double beyond : {0x1p-30, 0x1p-45, 0x1p-52, 0.0, -0x1p-52}) {
    CAPTURE(beyond);
    // The lower edge of a wall is below the floor by this amount, or not.
    const Lattice lattice({{{0x1p-20, 0, 1}, beyond}});
    const std::uint32_t edge = 27;
    const Polygon floor = Lattice::rectangle(2, 0, {-2, -2}, {2, 2});
    const Polygon wall{
        Lattice::number(0, 0),
        {{edge, false}, {Lattice::number(2, 1), true}, {Lattice::number(1, -1), false}, {Lattice::number(1, 1), true}}};
    CHECK(lattice.cross(floor, wall) == (beyond > 0));
  }
}
