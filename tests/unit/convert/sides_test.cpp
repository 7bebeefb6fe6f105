#include "sim/software/convert/sides.h"

#include "sim/software/convert/crossings.h"
#include "sim/software/convert/near_points.h"
#include "sim/software/convert/outlines.h"
#include "sim/software/convert/point_table.h"
#include "sim/software/convert/sets.h"
#include "sim/software/convert/side.h"
#include "tests/oracle/split_mix.h"
#include "tests/support/test.h"
#include "tests/unit/convert/seats.h"

using namespace csgsim;
namespace convert = software::convert;
using convert::Outline;
using convert::Outlines;
using convert::PointAlong;
using convert::Side;
using testing::Random;

namespace {

std::vector<Side> cancelled(std::vector<Side> sides) {
  convert::cancel_opposite_sides(sides);
  return sides;
}

std::vector<std::uint32_t> all_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

std::vector<std::uint32_t> points_of(const std::vector<PointAlong>& found) {
  std::vector<std::uint32_t> points;
  points.reserve(found.size());
  for (const PointAlong& one : found) points.push_back(one.point);
  return points;
}

/// Result of splitting the sides of one outline.
struct Ended {
  bool any = false;
  std::vector<glm::dvec3> points;
  std::vector<Side> sides;
};

Ended ended(const std::vector<glm::dvec3>& points, const std::vector<Side>& sides, const glm::dvec3& outward) {
  Outlines outlines{points, {{outward, sides}}};
  const std::vector<std::size_t> which{0};
  const bool any = convert::try_split_at_crossings(which, outlines);
  return {any, outlines.points, outlines.outlines[0].sides};
}

}  // namespace

TEST_CASE("opposite and degenerate sides of outlines are removed and the rest sorted") {
  CHECK(convert::ordered({3, 1}) == Side{1, 3});
  CHECK(convert::ordered({1, 3}) == Side{1, 3});
  CHECK(convert::key_of({3, 1}) == 0x100000003U);
  CHECK(convert::key_of({1, 3}) == 0x100000003U);
  CHECK(cancelled({{1, 2}, {2, 1}}).empty());
  CHECK(cancelled({{7, 7}}).empty());
  CHECK(cancelled({{1, 2}, {2, 1}, {1, 2}}) == std::vector<Side>{{1, 2}});
  CHECK(cancelled({{1, 2}, {2, 1}, {2, 1}}) == std::vector<Side>{{2, 1}});
  CHECK(cancelled({{1, 2}, {1, 2}, {1, 2}, {2, 1}}) == std::vector<Side>{{1, 2}, {1, 2}});
  CHECK(cancelled({{2, 1}, {1, 2}, {2, 1}, {2, 1}}) == std::vector<Side>{{2, 1}, {2, 1}});
  CHECK(cancelled({{5, 6}, {4, 3}, {2, 1}, {1, 2}, {1, 3}}) == std::vector<Side>{{1, 3}, {4, 3}, {5, 6}});
  CHECK(cancelled({}).empty());
}

TEST_CASE("the end points of sides are listed once in ascending order") {
  const std::vector<Side> sides{{5, 1}, {1, 7}, {7, 5}, {3, 3}};
  CHECK(convert::end_points_of(sides) == std::vector<std::uint32_t>{1, 3, 5, 7});
  CHECK(convert::end_points_of({}).empty());
}

TEST_CASE("sides are split at their points in either direction") {
  const convert::PointsOnSides ends{{convert::key_of({1, 5}), {8, 7}}};
  std::vector<Side> sides{{1, 5}, {2, 3}};
  CHECK(convert::try_split_sides(ends, sides));
  CHECK(sides == std::vector<Side>{{1, 8}, {2, 3}, {7, 5}, {8, 7}});
  sides = {{5, 1}};
  CHECK(convert::try_split_sides(ends, sides));
  CHECK(sides == std::vector<Side>{{8, 1}, {5, 7}, {7, 8}});
  // Opposite sides cancel after the split.
  sides = {{5, 1}, {1, 8}};
  CHECK(convert::try_split_sides(ends, sides));
  CHECK(sides == std::vector<Side>{{5, 7}, {7, 8}});
  // Nothing changes without points, including the order.
  sides = {{4, 5}, {1, 2}, {2, 1}};
  CHECK(!convert::try_split_sides(ends, sides));
  CHECK(sides == std::vector<Side>{{4, 5}, {1, 2}, {2, 1}});
}

TEST_CASE("joined sets of points are represented by their smallest member") {
  convert::DisjointSets sets(7);
  for (std::uint32_t i = 0; i < 7; ++i) CHECK(sets.find(i) == i);
  sets.join(5, 3);
  sets.join(6, 5);
  CHECK(sets.find(6) == 3);
  CHECK(sets.find(5) == 3);
  sets.join(1, 2);
  sets.join(2, 6);
  for (const std::uint32_t i : {1U, 2U, 3U, 5U, 6U}) CHECK(sets.find(i) == 1);
  CHECK(sets.find(0) == 0);
  CHECK(sets.find(4) == 4);
}

TEST_CASE("points within the tolerance in each coordinate merge with the first") {
  for (const glm::dvec3& centre : {glm::dvec3(0), glm::dvec3(-3, 5, 70)}) {
    convert::PointTable table(centre, 0.125);
    CHECK(table.add(centre) == 0);
    std::uint32_t added = 0;
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1.0, 1.0}) {
        CAPTURE(axis);
        CAPTURE(sign);
        glm::dvec3 near(0.12);
        near[axis] *= sign;
        CHECK(table.add(centre + near) == 0);
        glm::dvec3 far(0);
        far[axis] = sign * 0.13;
        CHECK(table.add(centre + far) == ++added);
        CHECK(table.points().back() == centre + far);
        CHECK(table.add(centre + far) == added);
      }
    }
    // A point within the tolerance of two points merges with the earlier one.
    CHECK(table.add(centre + glm::dvec3(0.07, 0, 0)) == 0);
    CHECK(table.points().size() == 7);
    CHECK(table.points().front() == centre);
  }
}

TEST_CASE("points within a distance of a line are found in order along it") {
  Random random(11);
  int found_any = 0;
  for (int i = 0; i < 60; ++i) {
    std::vector<glm::dvec3> points;
    const double flat = random.one_of({0.0, 1e-3, 1.0});  // includes lines along axes and in one plane
    for (int k = 0; k < 60; ++k)
      points.emplace_back(random.unit(), random.one_of({flat, 1.0}) * random.unit(), flat * random.unit());
    const convert::NearPoints near(points, all_numbers(points.size()));
    for (std::uint32_t from = 0; from < 6; ++from) {
      for (std::uint32_t to = 3; to < 9; ++to) {
        if (from == to) continue;
        const double distance = random.one_of({0.02, 0.1});
        const std::vector<PointAlong> beside = near.beside(from, to, distance);
        CHECK(std::is_sorted(beside.begin(), beside.end()));
        const glm::dvec3 way = points[to] - points[from];
        const double square = glm::dot(way, way);
        std::vector<PointAlong> sure;
        for (std::uint32_t k = 0; k < points.size(); ++k) {
          const glm::dvec3 out = points[k] - points[from];
          const double along = glm::dot(out, way) / square;
          const double off = std::sqrt(std::max(0.0, glm::dot(out, out) - along * along * square));
          const auto known = std::ranges::find(beside, k, &PointAlong::point);
          if (known != beside.end()) {
            CHECK(known->along == doctest::Approx(along));
            CHECK(off <= distance + 1e-9);
          } else if (k != from && k != to && along >= 0 && along <= 1) {
            CHECK(off > distance - 1e-9);
          }
          CHECK((known == beside.end() || (k != from && k != to)));
        }
        if (!beside.empty()) ++found_any;
      }
    }
  }
  CHECK(found_any > 500);
}

TEST_CASE("points at exactly the distance from a line or from coincident ends are found") {
  const std::vector<glm::dvec3> points{{0, 0, 0}, {8, 0, 0},   {4, 0.125, 0}, {2, 0, 0.1251}, {6, 0, -0.125},
                                       {0, 0, 0}, {8.5, 0, 0}, {1, 0, 0},     {1, 0, 0}};
  const convert::NearPoints near(points, all_numbers(points.size()));
  CHECK(points_of(near.beside(0, 1, 0.125)) == std::vector<std::uint32_t>{5, 7, 8, 2, 4});
  const std::vector<PointAlong> back = near.beside(1, 0, 0.125);
  CHECK(points_of(back) == std::vector<std::uint32_t>{4, 2, 7, 8, 5});
  CHECK(back[0].along == 0.25);
  CHECK(back[1].along == 0.5);
  CHECK(back[4].along == 1);
  CHECK(points_of(near.beside(0, 5, 0.5)).empty());
  CHECK(points_of(near.beside(0, 5, 1)) == std::vector<std::uint32_t>{7, 8});
  CHECK(near.beside(0, 5, 1).front().along == 0);
  // Unused points are not found.
  const std::vector<std::uint32_t> used{0, 1, 4};
  const convert::NearPoints few(points, used);
  CHECK(points_of(few.beside(0, 1, 0.125)) == std::vector<std::uint32_t>{4});
  CHECK(PointAlong{1, 5} < PointAlong{2, 3});
  CHECK(PointAlong{1, 3} < PointAlong{1, 5});
  CHECK_FALSE(PointAlong{1, 5} < PointAlong{1, 5});
}

TEST_CASE("sides of selected outlines are split at points within the tolerance") {
  // All points are near the line from 0 to 1 except 6; 4 and 5 lie beyond its ends, and 7 at its end.
  Outlines outlines{{{0, 0, 0},
                     {4, 0, 0},
                     {1, 0.05, 0},
                     {3, 0, -0.05},
                     {4.05, 0, 0},
                     {-0.05, 0, 0},
                     {2, 0.2, 0},
                     {4, 0.05, 0},
                     {0, 0.05, 0},
                     {0, 9, 0},
                     {4, 9, 0}},
                    {{{0, 0, 1}, {{0, 1}}}, {{0, 0, 1}, {{1, 0}}}, {{0, 0, 1}, {{9, 10}}}}};
  const convert::NearPoints near(outlines.points, all_numbers(outlines.points.size()));
  const std::vector<std::size_t> which{0, 2};
  CHECK(convert::split_at_points(which, near, 0.1, outlines) == std::vector<std::size_t>{0});
  CHECK(outlines.outlines[0].sides == std::vector<Side>{{0, 2}, {3, 1}, {2, 3}});
  CHECK(outlines.outlines[1].sides == std::vector<Side>{{1, 0}});
  CHECK(outlines.outlines[2].sides == std::vector<Side>{{9, 10}});
  const std::vector<std::size_t> last{2};
  CHECK(convert::split_at_points(last, near, 0.1, outlines).empty());
  const std::vector<std::size_t> second{1, 2};
  CHECK(convert::split_at_points(second, near, 0.1, outlines) == std::vector<std::size_t>{1});
  CHECK(outlines.outlines[1].sides == std::vector<Side>{{2, 0}, {1, 3}, {3, 2}});
}

TEST_CASE("collinear sides are joined where no third side meets them") {
  // A square from 0 to 3 with the points 4, 5 and 6 on its lower side. At 6 either a third side begins or the lower
  // side bends.
  struct Row {
    glm::dvec3 at;
    bool has_third;
    bool is_joined;
  };
  for (const Row& row : {Row{{3, 0, 0}, false, true}, Row{{3, 0, 0}, true, false}, Row{{3, 0.0624, 0}, false, true},
                         Row{{3, 0.14, 0}, false, false}}) {
    CAPTURE(row.at.y);
    CAPTURE(row.has_third);
    Outlines outlines{{{0, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}, {1, 0, 0}, {2, 0, 0}, row.at}, {}};
    const std::vector<Side> up{{0, 4}, {4, 5}, {5, 6}, {6, 1}, {1, 2}, {2, 3}, {3, 0}};
    std::vector<Side> down;
    for (const Side& side : up) down.push_back({side[1], side[0]});
    outlines.outlines = {{{0, 0, 1}, up}, {{0, 0, -1}, down}};
    if (row.has_third) {
      outlines.outlines[0].sides.push_back({6, 2});
      outlines.outlines[1].sides.push_back({2, 6});
    }
    convert::join_straight(outlines, 0.0625);
    // Point 4 is removed in any case; 5 too, if 6 is close enough to its line.
    const std::vector<Side>& sides = outlines.outlines[0].sides;
    const auto has = [&](const Side& side) { return std::ranges::find(sides, side) != sides.end(); };
    CHECK(has({0, 1}) == row.is_joined);
    CHECK(has({6, 1}) != row.is_joined);
    CHECK(has({1, 2}));
    CHECK(has({2, 3}));
    CHECK(has({3, 0}));
    CHECK(!has({4, 5}));
    std::vector<Side> backs;
    for (const Side& side : outlines.outlines[1].sides) backs.push_back({side[1], side[0]});
    std::vector<Side> forth = sides;
    std::ranges::sort(backs);
    std::ranges::sort(forth);
    CHECK(forth == backs);
  }
}

TEST_CASE("sides that reverse their direction are not joined") {
  for (const bool is_exchanged : {false, true}) {
    // The path runs from the middle to the right end and back to the left.
    Outlines outlines{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 5, 0}}, {}};
    const std::vector<Side> sides = is_exchanged ? std::vector<Side>{{1, 2}, {2, 0}, {0, 3}, {3, 1}}
                                                 : std::vector<Side>{{0, 2}, {2, 1}, {1, 3}, {3, 0}};
    outlines.outlines = {{{0, 0, 1}, sides}};
    convert::join_straight(outlines, 0.1);
    std::vector<Side> left = outlines.outlines[0].sides;
    CHECK(left == sides);
  }
}

TEST_CASE("open_side() returns a side without its reverse or nothing if all have one") {
  Outlines outlines{{}, {{{0, 0, 1}, {{0, 1}, {1, 2}, {2, 0}}}, {{0, 0, 1}, {{1, 0}, {2, 1}}}}};
  CHECK(convert::open_side(outlines) == std::optional<Side>(Side{2, 0}));
  outlines.outlines[1].sides.push_back({0, 2});
  CHECK(convert::open_side(outlines) == std::nullopt);
}

TEST_CASE("crossing sides are split at a point midway for each direction of view") {
  for (const testing::Seat& seat : testing::seats) {
    CAPTURE(seat.outward.x);
    CAPTURE(seat.outward.y);
    CAPTURE(seat.outward.z);
    const auto at = [&](double x, double y, double out) { return x * seat.right + y * seat.up + out * seat.outward; };
    // The sides from (0, 0) to (4, 4) and from (0, 3) to (4, -1) cross at (1.5, 1.5), one 1 above the other.
    const Ended crossed = ended({at(0, 0, 0), at(4, 4, 0), at(0, 3, 1), at(4, -1, 1)}, {{0, 1}, {3, 2}}, seat.outward);
    CHECK(crossed.any);
    REQUIRE(crossed.points.size() == 5);
    CHECK(crossed.sides == std::vector<Side>{{0, 4}, {4, 1}, {4, 2}, {3, 4}});
    if (seat.outward.x == 0.6) continue;  // not along the projection axis
    CHECK(glm::distance(crossed.points[4], at(1.5, 1.5, 0.5)) < 1e-12);
  }
}

TEST_CASE("sides are split at ends on them but not at common ends") {
  const glm::dvec3 z(0, 0, 1);
  // The other side starts at the middle of the first one, in each of the four directions; the bounding boxes only
  // touch.
  for (const glm::dvec3& far : {glm::dvec3(2, 3, 0), glm::dvec3(2, -3, 0)}) {
    const Ended down = ended({{0, 0, 0}, {4, 0, 0}, {2, 0, 0}, far}, {{0, 1}, {2, 3}}, z);
    CHECK(down.any);
    CHECK(down.points.size() == 4);
    CHECK(down.sides == std::vector<Side>{{0, 2}, {2, 1}, {2, 3}});
  }
  for (const glm::dvec3& far : {glm::dvec3(3, 2, 0), glm::dvec3(-3, 2, 0)}) {
    const Ended across = ended({{0, 0, 0}, {0, 4, 0}, {0, 2, 0}, far}, {{1, 0}, {3, 2}}, z);
    CHECK(across.any);
    CHECK(across.points.size() == 4);
    CHECK(across.sides == std::vector<Side>{{2, 0}, {1, 2}, {3, 2}});
  }
  // Collinear sides from 0 to 4 and from 3 to 6.
  const Ended line = ended({{0, 0, 0}, {4, 0, 0}, {3, 0, 0}, {6, 0, 0}}, {{0, 1}, {2, 3}}, z);
  CHECK(line.any);
  CHECK(line.sides == std::vector<Side>{{0, 2}, {2, 1}, {2, 1}, {1, 3}});
  for (const std::vector<glm::dvec3>& points :
       {std::vector<glm::dvec3>{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}) {
    const Ended joined = ended(points, {{0, 1}, {1, 2}, {2, 0}}, z);
    CHECK(!joined.any);
    CHECK(joined.points.size() == 3);
  }
  // Equal and opposite sides do not cross.
  CHECK(!ended({{0, 0, 0}, {4, 0, 0}}, {{0, 1}, {0, 1}, {1, 0}}, z).any);
  // Sides next to each other or one before the other do not cross.
  CHECK(!ended({{0, 0, 0}, {4, 4, 0}, {1, 0, 0}, {5, 4, 0}}, {{0, 1}, {2, 3}}, z).any);
  CHECK(!ended({{0, 0, 0}, {4, 4, 0}, {3, 2, 0}, {3, -2, 0}}, {{0, 1}, {2, 3}}, z).any);
  CHECK(!ended({{0, 0, 0}, {1, 1, 0}, {0, 4, 0}, {4, 0, 0}}, {{0, 1}, {2, 3}}, z).any);
}

TEST_CASE("a crossing side is split in all outlines and others are left alone") {
  Outlines outlines{{{0, 0, 0}, {4, 4, 0}, {0, 4, 0}, {4, 0, 0}},
                    {{{0, 0, 1}, {{0, 1}, {2, 3}}}, {{0, 1, 0}, {{1, 0}}}}};
  Outlines other = outlines;
  const std::vector<std::size_t> first{0};
  CHECK(convert::try_split_at_crossings(first, outlines));
  CHECK(outlines.outlines[1].sides == std::vector<Side>{{4, 0}, {1, 4}});
  const std::vector<std::size_t> second{1};
  CHECK(!convert::try_split_at_crossings(second, other));
  CHECK(other.points.size() == 4);
}

namespace {

struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// 1, 0 or -1 for a left turn, no turn or a right turn.
int turn_at(const GridPoint& a, const GridPoint& b, const GridPoint& c) {
  const std::int64_t twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
  return twice > 0 ? 1 : twice < 0 ? -1 : 0;
}

}  // namespace

TEST_CASE("crossings of random sides match integer arithmetic in order") {
  Random random(5);
  int crossings = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<GridPoint> grid;
    std::vector<glm::dvec3> points;
    std::vector<Side> sides;
    for (std::uint32_t k = 0; k < 8; ++k) {
      for (int end = 0; end < 2; ++end) {
        const auto x = static_cast<std::int64_t>(random.below(1000));
        const auto y = static_cast<std::int64_t>(random.below(1000));
        grid.push_back({x, y});
        points.emplace_back(static_cast<double>(x), static_cast<double>(y), 0);
      }
      sides.push_back(random.below(2) == 0 ? Side{2 * k, 2 * k + 1} : Side{2 * k + 1, 2 * k});
    }
    std::size_t expected = 0;
    bool has_touching = false;
    for (std::size_t a = 0; a < 16; a += 2) {
      for (std::size_t b = 0; b < a; b += 2) {
        const int one = turn_at(grid[a], grid[a + 1], grid[b]) * turn_at(grid[a], grid[a + 1], grid[b + 1]);
        const int other = turn_at(grid[b], grid[b + 1], grid[a]) * turn_at(grid[b], grid[b + 1], grid[a + 1]);
        if (one == 0 || other == 0) has_touching = true;
        if (one < 0 && other < 0) ++expected;
      }
    }
    if (has_touching) continue;
    const Ended made = ended(points, sides, {0, 0, 1});
    CHECK(made.points.size() == 16 + expected);
    CHECK(made.sides.size() == 8 + 2 * expected);
    crossings += static_cast<int>(expected);
    // The parts of a side follow each other from its start.
    for (const Side& side : sides) {
      const glm::dvec3 way = points[side[1]] - points[side[0]];
      std::uint32_t at = side[0];
      for (int part = 0; part < 9 && at != side[1]; ++part) {
        const auto next = std::ranges::find_if(made.sides, [&](const Side& one) {
          return one[0] == at &&
                 glm::length(glm::cross(glm::normalize(way), made.points[one[1]] - points[side[0]])) < 1e-6 &&
                 glm::dot(way, made.points[one[1]] - made.points[at]) > 0;
        });
        if (next == made.sides.end()) break;
        at = (*next)[1];
      }
      CHECK(at == side[1]);
    }
  }
  CHECK(crossings > 300);
}
