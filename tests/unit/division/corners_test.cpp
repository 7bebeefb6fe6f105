#include "hw/division/corners.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "tests/unit/division/hand_models.h"

using namespace csgsim;
using division::Known;
using division::Plane;
using division::Tested;

namespace {

constexpr division::Rectangle pixels{0, 0, 10, 0};

/// Half-spaces of one side at the corners of 11 pixels in a row, plane after plane.
std::vector<Tested> side_of(const std::vector<Plane>& planes, bool forward) {
  division::DisplayModel model = testing::empty_model();
  model.planes = planes;
  std::vector<Tested> side;
  side.reserve(planes.size());
  for (std::uint32_t i = 0; i < planes.size(); ++i)
    side.push_back(division::test_corners(model, 0, {i, forward, 0}, pixels));
  return side;
}

std::vector<std::uint32_t> planes_of(const std::vector<Tested>& side) {
  std::vector<std::uint32_t> planes;
  planes.reserve(side.size());
  for (const Tested& one : side) planes.push_back(one.halfspace.plane);
  return planes;
}

std::vector<std::uint32_t> extremes(const std::vector<Plane>& planes, bool forward) {
  std::vector<Tested> side = side_of(planes, forward);
  division::keep_extremes(side, 1);
  return planes_of(side);
}

Known known(const Plane& plane, bool forward, std::int64_t z_low, std::int64_t z_high) {
  return division::known_between(side_of({plane}, forward)[0], z_low, z_high);
}

using Planes = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("a corner test finds the four values, and the floors of the least and the greatest") {
  division::DisplayModel model = testing::empty_model();
  model.fraction_bits = 2;
  model.planes = {{false, -3, 2, 10}, {false, 0, 0, -1}, {true, -3, 2, 10}};
  const Tested depth = division::test_corners(model, 7, {0, true, 5}, {1, 2, 4, 3});
  CHECK(depth.corners == std::array<std::int64_t, 4>{11, 2, 13, 4});
  CHECK(depth.low == 0);
  CHECK(depth.high == 3);
  CHECK(depth.side == division::Side::front);
  CHECK(depth.primitive == 7);
  const Tested below = division::test_corners(model, 0, {1, false, 0}, {1, 2, 4, 3});
  CHECK(below.low == -1);
  CHECK(below.side == division::Side::back);
  const Tested edge = division::test_corners(model, 0, {2, false, 0}, {1, 2, 4, 3});
  CHECK(edge.low == 2);
  CHECK(edge.high == 13);
  CHECK(edge.side == division::Side::negative);
}

TEST_CASE("of two fronts the one that is nearer at all corners is not active (thesis fig. 7.5a, convex-max)") {
  CHECK(extremes({{false, 1, 0, 2}, {false, 0, 0, 20}}, true) == Planes{1});
}

TEST_CASE("of two fronts that cross between the corners both are active (thesis fig. 7.5b)") {
  CHECK(extremes({{false, 1, 0, 2}, {false, -1, 0, 9}}, true) == Planes{0, 1});
}

TEST_CASE("of two backs the one that is farther at all corners is not active (thesis table 7.1, concave-min)") {
  CHECK(extremes({{false, 1, 0, 2}, {false, 0, 0, 20}}, false) == Planes{0});
  CHECK(extremes({{false, 1, 0, 2}, {false, -1, 0, 9}}, false) == Planes{0, 1});
}

TEST_CASE("a half-space goes only if another one is beyond it by a whole depth step at every corner") {
  std::vector<Tested> side = side_of({{false, 0, 0, 16}, {false, 0, 0, 23}, {false, 0, 0, 24}}, true);
  division::keep_extremes(side, 8);
  CHECK(planes_of(side) == Planes{1, 2});
}

TEST_CASE("coincident half-spaces are all active") {
  CHECK(extremes({{false, 1, 0, 2}, {false, 1, 0, 2}}, true) == Planes{0, 1});
}

TEST_CASE("what the extremes at the corners leave is held against each other, pair by pair") {
  // At the corners 20 and -10, -10 and 20, 8 and 8, 5 and 5: neither extreme is beyond 5 everywhere, but 8 is.
  const std::vector<Plane> planes{{false, -3, 0, 20}, {false, 3, 0, -10}, {false, 0, 0, 8}, {false, 0, 0, 5}};
  std::vector<Tested> by_leaders = side_of(planes, true);
  division::keep_by_leaders(by_leaders, 1);
  CHECK(planes_of(by_leaders) == Planes{0, 1, 2, 3});
  std::vector<Tested> by_pairs = side_of(planes, true);
  CHECK(division::keep_extremes(by_pairs, 1) == 6);
  CHECK(planes_of(by_pairs) == Planes{0, 1, 2});
  std::vector<Tested> alone = side_of({planes[0]}, true);
  CHECK(division::keep_extremes(alone, 1) == 0);
}

TEST_CASE("a front holds depths from its own on: all if it is never farther than the nearest, none if always beyond") {
  const Plane rising{false, 1, 0, 3};  // 3 to 13
  CHECK(known(rising, true, 13, 20) == Known::in);
  CHECK(known(rising, true, 12, 20) == Known::depends);
  CHECK(known(rising, true, 0, 2) == Known::out);
  CHECK(known(rising, true, 0, 3) == Known::depends);
}

TEST_CASE(
    "a back holds depths before its own: all if it is always beyond the farthest, none if never beyond the nearest") {
  const Plane rising{false, 1, 0, 3};
  CHECK(known(rising, false, 0, 2) == Known::in);
  CHECK(known(rising, false, 0, 3) == Known::depends);
  CHECK(known(rising, false, 13, 20) == Known::out);
  CHECK(known(rising, false, 12, 20) == Known::depends);
}

TEST_CASE("an edge test holds all pixels or none by its sign at the corners, zero with the positive values") {
  CHECK(known({true, 1, 0, 0}, true, 0, 0) == Known::in);
  CHECK(known({true, 1, 0, -1}, true, 0, 0) == Known::depends);
  CHECK(known({true, 1, 0, -11}, true, 0, 0) == Known::out);
  CHECK(known({true, 1, 0, 0}, false, 0, 0) == Known::out);
  CHECK(known({true, 1, 0, -10}, false, 0, 0) == Known::depends);
  CHECK(known({true, 1, 0, -11}, false, 0, 0) == Known::in);
}
