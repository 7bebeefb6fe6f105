#include "hw/division/corners.h"

#include "tests/support/test.h"
#include "tests/unit/division/hand_models.h"

using namespace csgsim;
using namespace division;

namespace {

constexpr division::Rectangle pixels{0, 0, 10, 0};

/// Half-spaces of one side at the corners of a row of 11 pixels, in the order of the planes.
std::vector<TestedHalfspace> side_of(const std::vector<Plane>& planes, bool forward) {
  division::DisplayModel model = testing::empty_model();
  model.planes = planes;
  std::vector<TestedHalfspace> side;
  side.reserve(planes.size());
  for (std::uint32_t i = 0; i < planes.size(); ++i)
    side.push_back(division::test_corners(model, {0, i, {i, forward, 0}, planes[i]}, pixels));
  return side;
}

Containment known(const Plane& plane, bool forward, std::int64_t z_low, std::int64_t z_high) {
  return division::classify_between(side_of({plane}, forward)[0], z_low, z_high);
}

}  // namespace

TEST_CASE("a corner test finds the four values and the floors of minimum and maximum") {
  division::DisplayModel model = testing::empty_model();
  model.fraction_bits = 2;
  model.planes = {{false, -3, 2, 10}, {false, 0, 0, -1}, {true, -3, 2, 10}};
  const TestedHalfspace depth = division::test_corners(model, {7, 3, {0, true, 5}, model.planes[0]}, {1, 2, 4, 3});
  CHECK(depth.corners == std::array<std::int64_t, 4>{11, 2, 13, 4});
  CHECK(depth.low == 0);
  CHECK(depth.high == 3);
  CHECK(depth.side == division::Side::front);
  CHECK(depth.primitive == 7);
  CHECK(depth.number == 3);
  const TestedHalfspace below = division::test_corners(model, {0, 0, {1, false, 0}, model.planes[1]}, {1, 2, 4, 3});
  CHECK(below.low == -1);
  CHECK(below.side == division::Side::back);
  const TestedHalfspace edge = division::test_corners(model, {0, 0, {2, false, 0}, model.planes[2]}, {1, 2, 4, 3});
  CHECK(edge.low == 2);
  CHECK(edge.high == 13);
  CHECK(edge.side == division::Side::negative);
}

TEST_CASE("a front contains blocks behind it and excludes blocks before it") {
  const Plane rising{false, 1, 0, 3};  // values 3 to 13
  CHECK(known(rising, true, 13, 20) == Containment::in);
  CHECK(known(rising, true, 12, 20) == Containment::depends);
  CHECK(known(rising, true, 0, 2) == Containment::out);
  CHECK(known(rising, true, 0, 3) == Containment::depends);
}

TEST_CASE("a back contains blocks before it and excludes blocks behind it") {
  const Plane rising{false, 1, 0, 3};
  CHECK(known(rising, false, 0, 2) == Containment::in);
  CHECK(known(rising, false, 0, 3) == Containment::depends);
  CHECK(known(rising, false, 13, 20) == Containment::out);
  CHECK(known(rising, false, 12, 20) == Containment::depends);
}

TEST_CASE("an edge is classified by its signs at the corners with zero as positive") {
  CHECK(known({true, 1, 0, 0}, true, 0, 0) == Containment::in);
  CHECK(known({true, 1, 0, -1}, true, 0, 0) == Containment::depends);
  CHECK(known({true, 1, 0, -11}, true, 0, 0) == Containment::out);
  CHECK(known({true, 1, 0, 0}, false, 0, 0) == Containment::out);
  CHECK(known({true, 1, 0, -10}, false, 0, 0) == Containment::depends);
  CHECK(known({true, 1, 0, -11}, false, 0, 0) == Containment::in);
}
