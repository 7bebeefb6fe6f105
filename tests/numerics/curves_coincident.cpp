#include "tests/numerics/curved_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

/// The same placement as a product of several matrices.
std::string round_about(const std::string& part) {
  const std::string there =
      with_transform(translation({0.1, 0.2, 0.3}), with_transform(translation({-0.1, -0.2, -0.3}), part));
  return with_transform(scaling({0.3, 0.7, 1.1}), with_transform(scaling({1 / 0.3, 1 / 0.7, 1 / 1.1}), there));
}

std::string tilted(const std::string& part) { return with_transform(rotation(33, 71), part); }

void check_empty(const std::string& csg, const CurvedLook& how = {}) {
  const CurvedVerdict verdict = look_at_all(csg, how);
  CHECK(verdict.covered == 0);
  CHECK(verdict.wrong == 0);
}

void check_seen(const std::string& csg, const CurvedLook& how = {}) {
  const CurvedVerdict verdict = look_at_all(csg, how);
  CHECK(verdict.covered > 200);
  CHECK(verdict.wrong <= verdict.covered / 50);
}

/// Checks that A - A is empty, and that the union and intersection are A, for either placement.
void check_same(const std::string& a, const std::string& b) {
  for (const bool is_tilted : {false, true}) {
    const std::string one = is_tilted ? tilted(a) : a;
    const std::string other = is_tilted ? round_about(tilted(b)) : b;
    CurvedLook how;
    how.shares = 4;
    check_empty(subtract({one, other}), how);
    ++how.share;
    check_empty(subtract({other, one}), how);
    ++how.share;
    check_seen(unite({one, other}), how);
    ++how.share;
    check_seen(intersect({one, other}), how);
  }
}

/// Checks that both have the same depth at every pixel.
void check_same_depths(const std::string& a, const std::string& b, const glm::dvec3& eye) {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    const csgsim::view::Camera camera{eye, {0, 0, 0}, projection};
    CHECK(curved_picture(a, camera).depth == curved_picture(b, camera).depth);
  }
}

}  // namespace

TEST_CASE("a cylinder minus itself is empty for any chain of transforms") {
  check_same(rod({0, 0, -5}, 10, 4), round_about(rod({0, 0, -5}, 10, 4)));
}
TEST_CASE("a cylinder minus itself turned about its axis is empty") {
  check_same(rod({0, 0, -5}, 10, 4), with_transform(rotation(0, 33), rod({0, 0, -5}, 10, 4)));
}
TEST_CASE("a cylinder minus itself upside down is empty") {
  check_same(rod({0, 0, -5}, 10, 4), with_transform(rotation(180, 0), rod({0, 0, -5}, 10, 4)));
}
TEST_CASE("a ball minus itself is empty for any chain of transforms") {
  check_same(ball({1, 2, 3}, 5), round_about(ball({1, 2, 3}, 5)));
  check_same(ball({0, 0, 0}, 5), with_transform(rotation(20, 50), ball({0, 0, 0}, 5)));
}
TEST_CASE("a ball minus a ball of half the size scaled by two is empty") {
  check_same(ball({0, 0, 0}, 6), with_transform(scaling({2, 2, 2}), ball({0, 0, 0}, 3)));
}
TEST_CASE("a ball minus its mirror image is empty") {
  check_same(ball({0, 0, 0}, 6), with_transform(scaling({-1, 1, 1}), ball({0, 0, 0}, 6)));
}
TEST_CASE("a cone minus itself is empty for any chain of transforms") {
  check_same(cylinder({0, 0, -5}, 10, 5, 0), round_about(cylinder({0, 0, -5}, 10, 5, 0)));
}
TEST_CASE("a frustum minus itself upside down is empty") {
  check_same(cylinder({0, 0, -5}, 10, 5, 2), with_transform(rotation(180, 0), cylinder({0, 0, -5}, 10, 2, 5)));
}
TEST_CASE("an ellipsoid minus itself is empty for any chain of transforms") {
  const std::string egg = with_transform(scaling({1, 2, 0.5}), ball({0, 0, 0}, 5));
  check_same(egg, round_about(egg));
}
TEST_CASE("a tube with flush ends is open and leaves no speckles of its walls") {
  check_seen(subtract({rod({0, 0, 0}, 8, 8), rod({0, 0, 0}, 8, 4)}));
  check_seen(tilted(subtract({rod({0, 0, 0}, 8, 8), round_about(rod({0, 0, 0}, 8, 4))})));
}
TEST_CASE("a plug as wide as the bore of a tube completes the cylinder") {
  const std::string tube = subtract({rod({0, 0, 0}, 8, 8), rod({0, 0, -1}, 10, 4)});
  check_seen(unite({tube, round_about(rod({0, 0, 0}, 8, 4))}));
  check_same_depths(unite({tube, rod({0, 0, 0}, 8, 4)}), rod({0, 0, 0}, 8, 8), {31, -37, 29});
}
TEST_CASE("a tube and its plug do not intersect") {
  const std::string tube = subtract({rod({0, 0, 0}, 8, 8), rod({0, 0, -1}, 10, 4)});
  check_empty(intersect({tube, round_about(rod({0, 0, 0}, 8, 4))}));
}
TEST_CASE("two nested tubes with a common wall are one tube") {
  const std::string wide = subtract({rod({0, 0, 0}, 8, 8), rod({0, 0, -1}, 10, 6)});
  const std::string narrow = subtract({rod({0, 0, 0}, 8, 6), rod({0, 0, -1}, 10, 4)});
  check_seen(unite({wide, round_about(narrow)}));
  check_empty(intersect({wide, round_about(narrow)}));
}
TEST_CASE("round cylinders of equal radius end to end are one cylinder") {
  check_seen(unite({rod({0, 0, 0}, 5, 4), round_about(rod({0, 0, 5}, 5, 4))}));
  check_same_depths(unite({rod({0, 0, -5}, 5, 4), rod({0, 0, 0}, 5, 4)}), rod({0, 0, -5}, 10, 4), {31, -37, 29});
}
TEST_CASE("half of a cylinder remains when the other half is subtracted") {
  check_seen(subtract({rod({0, 0, 0}, 10, 4), round_about(rod({0, 0, 5}, 5, 4))}));
  check_seen(subtract({rod({0, 0, 0}, 10, 4), round_about(rod({0, 0, 2}, 5, 4))}));
}
TEST_CASE("a round cone that continues a cone of the same slope is one cone") {
  check_seen(unite({cylinder({0, 0, 0}, 4, 8, 6), round_about(cylinder({0, 0, 4}, 4, 6, 4))}));
  check_seen(subtract({cylinder({0, 0, 0}, 16, 8, 0), round_about(cylinder({0, 0, 4}, 4, 6, 4))}));
}
TEST_CASE("cones that touch at their tips are drawn correctly and do not intersect") {
  const std::string up = cylinder({0, 0, 0}, 6, 0, 4);
  const std::string down = cylinder({0, 0, -6}, 6, 4, 0);
  check_seen(unite({up, down}));
  check_seen(subtract({up, round_about(down)}));
  check_empty(intersect({up, down}));
}
TEST_CASE("a ball split by a plane and united again is the ball") {
  const std::string slab = box({-20, -20, -20}, {20, 1, 20});
  const std::string body = ball({0, 0, 0}, 6);
  const std::string again = unite({intersect({body, slab}), subtract({body, slab})});
  check_seen(again);
  check_same_depths(again, body, {31, -37, 29});
}
TEST_CASE("balls with walls as thin as 2^-16 are hollow") {
  for (const double wall : {0x1p-2, 0x1p-8, 0x1p-16}) {
    look_at_all(subtract({ball({0, 0, 0}, 8), ball({0, 0, 0}, 8 - wall)}));
    look_at_all(subtract({ball({0, 0, 0}, 8), ball({0, 0, 0}, 8 - wall), box({0, -9, 0}, {9, 9, 9})}));
  }
}
TEST_CASE("balls and cylinders one depth step or less apart keep their order") {
  // A depth step of 8 bits is at least a sixteenth of a unit.
  CurvedLook coarse;
  coarse.z_bits = 8;
  for (const double step : {16.0 / 252, 8.0 / 252, 0x1p-12}) {
    for (const double more : {step, -step}) {
      look_at_all(unite({ball({0, 0, 0}, 8), ball({0, 0, 0}, 8 + more)}), coarse);
      look_at_all(subtract({ball({0, 0, 0}, 8), ball({0, 0, 0}, 8 + more)}), coarse);
      look_at_all(unite({rod({0, 0, -8}, 16, 4), rod({0, 0, -8}, 16, 4 + more)}), coarse);
    }
  }
}
