#include "tests/numerics/curved_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

const std::string upright = rod({0, 0, -4}, 8, 4);
const std::string tube = subtract({rod({0, 0, -4}, 8, 4), rod({0, 0, -4}, 8, 2)});
const std::string cone = cylinder({0, 0, -4}, 8, 4, 0);
const std::string frustum = cylinder({0, 0, -4}, 8, 4, 2);
const std::string oval = with_transform(scaling({1, 0.5, 1}), upright);

/// Looks down at a number of degrees from the axis.
CurvedVerdict look_down(const std::string& csg, double degrees, const CurvedLook& how = lenient) {
  const double angle = degrees * std::numbers::pi / 180;
  return look_both_ways(csg, {40 * std::sin(angle), 0, 40 * std::cos(angle)}, {0, 0, 0}, how);
}

void check_tilts(const std::string& csg) {
  for (const double degrees : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 0.1, 1.0}) {
    CAPTURE(degrees);
    CHECK(look_down(csg, degrees).covered > 100);
  }
}

}  // namespace

TEST_CASE("a cylinder seen exactly along its axis is a disc") {
  const CurvedVerdict verdict = look_down(upright, 0);
  CHECK(verdict.quadrics == 2);
  CHECK(verdict.edges == 1);
  CHECK(verdict.covered > 100);
  CHECK(verdict.wrong <= 4);
}
TEST_CASE("a cylinder seen nearly along its axis is drawn correctly at all tilts") { check_tilts(upright); }
TEST_CASE("a tube seen exactly along its axis is a ring") {
  const CurvedVerdict verdict = look_down(tube, 0);
  CHECK(verdict.covered > 100);
  CHECK(verdict.wrong <= 8);
}
TEST_CASE("a tube seen nearly along its axis is drawn correctly at all tilts") { check_tilts(tube); }
TEST_CASE("an elliptic cylinder seen along or nearly along its axis is drawn correctly") {
  look_down(oval, 0);
  check_tilts(oval);
}
TEST_CASE("a cone seen exactly along its axis is drawn correctly from tip and base") {
  CHECK(look_down(cone, 0).covered > 100);
  CHECK(look_down(cone, 180).covered > 100);
  CHECK(look_down(frustum, 0).covered > 100);
  CHECK(look_down(frustum, 180).covered > 100);
}
TEST_CASE("a cone seen nearly along its axis is drawn correctly at all tilts") { check_tilts(cone); }
TEST_CASE("a cone seen nearly along a generating line is drawn correctly or in facets") {
  // Half the angle at the apex.
  const double side = std::atan2(4.0, 8.0) * 180 / std::numbers::pi;
  for (const double off : {0.0, 1e-9, 1e-6, 1e-3, 0.1, -1e-9, -1e-6, -1e-3, -0.1}) {
    CAPTURE(off);
    look_down(cone, side + off);
    look_down(subtract({box({-5, -5, -4}, {5, 5, 5}), cone}), side + off);
    look_down(cone, 180 - side + off);
  }
}
TEST_CASE("a cone with a half angle of 45 degrees is seen exactly along a generating line") {
  const std::string right_angled = cylinder({0, 0, -4}, 8, 8, 0);
  look_both_ways(right_angled, {0, -40, 40}, {0, 0, 0}, lenient);
  look_both_ways(right_angled, {0, -40, 44}, {0, 0, 4}, lenient);
  look_both_ways(subtract({box({-9, -9, -4}, {9, 9, 5}), right_angled}), {0, -40, 44}, {0, 0, 4}, lenient);
}
TEST_CASE("a cylinder seen exactly from the side has its ends edge-on") {
  look_both_ways(upright, {0, -40, 0}, {0, 0, 0});
  look_both_ways(upright, {0, -40, 4}, {0, 0, 4});
  look_both_ways(tube, {0, -40, 0}, {0, 0, 0});
}
TEST_CASE("a cylinder subtracted from a wall and seen along its axis is a round hole") {
  const std::string wall = box({-8, -8, -2}, {8, 8, 2});
  for (const double degrees : {0.0, 1e-4, 1e-2, 1.0, 10.0}) {
    CAPTURE(degrees);
    CHECK(look_down(subtract({wall, upright}), degrees).covered > 100);
  }
}
TEST_CASE("an eye on the axis of a cylinder sees it correctly from outside and inside") {
  const std::string pit = subtract({box({-8, -8, -8}, {8, 8, 4}), rod({0, 0, -4}, 9, 4)});
  for (const double height : {40.0, 4.0, 2.0, -3.0}) {
    CAPTURE(height);
    CurvedLook how;
    how.near = 0.5;
    CHECK(look_curved(pit, {{0, 0, height}, {0, 0, -8}, Projection::perspective}, how).covered > 100);
  }
}
