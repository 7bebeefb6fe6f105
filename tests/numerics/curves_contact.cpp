#include "tests/numerics/curved_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

// Sizes are sums of few powers of two, so touching surfaces also touch in double precision.

std::string lying(const std::string& part) {
  return with_transform("[[1,0,0,0],[0,0,-1,0],[0,1,0,0],[0,0,0,1]]", part);
}

const std::string left = ball({-4, 0, 0}, 4);
const std::string right = ball({4, 0, 0}, 4);
const std::string outer = ball({0, 0, 0}, 8);
const std::string inner = ball({4, 0, 0}, 4);
const std::string table = box({-16, -16, -4}, {16, 16, 0});

/// Along a line seen end-on, touching surfaces may belong to either solid.
void check_seen(const std::string& csg, const CurvedLook& how = {}) {
  const CurvedVerdict verdict = look_at_all(csg, how);
  CHECK(verdict.covered > 200);
  CHECK(verdict.wrong <= verdict.covered / 20);
}

void check_nearly_nothing(const std::string& csg) {
  const CurvedVerdict verdict = look_at_all(csg);
  CHECK(verdict.covered == 0);
  CHECK(verdict.wrong <= 4);
}

/// Draws all set operations of two solids in both orders. Facets are allowed where the eye is on a surface or where
/// rays follow a straight line in it.
void check_all_of(const std::string& a, const std::string& b, bool may_be_faceted = false) {
  CurvedLook how;
  how.may_be_faceted = may_be_faceted;
  how.shares = 5;
  check_seen(unite({a, b}), how);
  how.share = 1;
  check_seen(unite({b, a}), how);
  for (const std::string& csg : {subtract({a, b}), subtract({b, a}), intersect({a, b})}) {
    ++how.share;
    look_at_all(csg, how);
  }
}

constexpr bool perhaps_in_facets = true;

}  // namespace

TEST_CASE("balls that touch from outside are two balls in a union") {
  check_seen(unite({left, right}));
  check_seen(unite({right, left}));
}
TEST_CASE("a ball minus one that touches it from outside is unchanged") {
  check_seen(subtract({left, right}));
  check_seen(subtract({right, left}));
}
TEST_CASE("balls that touch from outside do not intersect") { check_nearly_nothing(intersect({left, right})); }
TEST_CASE("a ball that touches another from inside is invisible in their union") { check_seen(unite({outer, inner})); }
TEST_CASE("a ball minus one that touches it from inside is hollow") {
  check_seen(subtract({outer, inner}));
  check_nearly_nothing(subtract({inner, outer}));
}
TEST_CASE("the intersection of a ball and one that touches it from inside is the inner ball") {
  check_seen(intersect({outer, inner}));
}
TEST_CASE("balls that nearly touch from outside are drawn correctly with gap or overlap") {
  for (const double gap : {0x1p-8, 0x1p-20, -0x1p-8, -0x1p-20}) {
    const std::string other = ball({4 + gap, 0, 0}, 4);
    look_at_all(unite({left, other}));
    look_at_all(intersect({left, other}));
    look_at_all(subtract({left, other}));
  }
}
TEST_CASE("balls that nearly touch from inside are drawn correctly with gap or overlap") {
  for (const double gap : {0x1p-8, 0x1p-20, -0x1p-8, -0x1p-20}) {
    const std::string other = ball({4 + gap, 0, 0}, 4);
    check_all_of(outer, other);
  }
}
TEST_CASE("a ball that touches a plane from above stands on it") { check_all_of(table, ball({0, 0, 8}, 8)); }
TEST_CASE("a ball that touches a plane from below makes no hole in it") {
  check_seen(subtract({table, ball({0, 0, -2}, 2)}));
  check_seen(unite({table, ball({0, 0, -2}, 2)}));
}
TEST_CASE("a ball that nearly touches a plane is drawn correctly on both sides of it") {
  for (const double gap : {0x1p-12, 0x1p-22, -0x1p-12, -0x1p-22}) check_all_of(table, ball({0, 0, 8 + gap}, 8));
}
TEST_CASE("a ball that touches all six faces of a cube from inside is drawn correctly") {
  check_all_of(box({-8, -8, -8}, {8, 8, 8}), outer);
}
TEST_CASE("a ball that touches all edges of a cube is drawn correctly") {
  check_all_of(box({-8, -8, -8}, {8, 8, 8}), ball({0, 0, 0}, 11.313708498984761));
}
TEST_CASE("parallel cylinders that touch along a line are drawn correctly") {
  check_all_of(rod({-4, 0, -8}, 16, 4), rod({4, 0, -8}, 16, 4));
  check_all_of(lying(rod({-4, 0, -8}, 16, 4)), lying(rod({4, 0, -4}, 16, 4)), perhaps_in_facets);
}
TEST_CASE("a cylinder that touches another's wall from inside is drawn correctly") {
  check_all_of(rod({0, 0, 0}, 8, 8), rod({4, 0, 0}, 8, 4));
  check_all_of(rod({0, 0, 0}, 8, 8), rod({4, 0, -2}, 12, 4));
}
TEST_CASE("a cylinder that lies on a plane is drawn correctly") {
  check_all_of(table, with_transform(translation({0, 0, 4}), lying(rod({0, 0, -8}, 16, 4))), perhaps_in_facets);
}
TEST_CASE("a cone that lies on a plane is drawn correctly") {
  // The cone's half angle belongs to a right triangle with sides 3, 4 and 5; the cone is turned by it.
  const std::string cone = cylinder({0, 0, 0}, 8, 0, 6);
  check_all_of(table, with_transform("[[1,0,0,0],[0,0.6,-0.8,0],[0,0.8,0.6,0],[0,0,0,1]]", cone), perhaps_in_facets);
}
TEST_CASE("a ball in a cylinder of its radius is drawn correctly") {
  check_all_of(rod({0, 0, -8}, 16, 4), ball({0, 0, 0}, 4));
  check_all_of(rod({0, 0, -8}, 16, 4), ball({0, 0, 8}, 4));
}
TEST_CASE("a ball that touches a cylinder's wall at one place is drawn correctly") {
  check_all_of(rod({0, 0, -8}, 16, 8), ball({4, 0, 0}, 4));
  check_all_of(rod({0, 0, -8}, 16, 8), ball({12, 0, 0}, 4));
}
TEST_CASE("a ball that touches a cone along a circle is drawn correctly") {
  // The half angle is that of a 3-4-5 triangle: a ball of radius 3 touches the cone if its centre is 5 from the apex.
  check_all_of(cylinder({0, 0, 0}, 8, 0, 6), ball({0, 0, 5}, 3));
}
TEST_CASE("a ball drilled by a cylinder that touches its surface is drawn correctly") {
  check_all_of(outer, rod({4, 0, -16}, 32, 4));
  check_all_of(outer, lying(rod({4, 0, -16}, 32, 4)), perhaps_in_facets);
}
TEST_CASE("a hollow ball that is drilled where it touches itself is drawn correctly") {
  check_seen(subtract({outer, inner, rod({0, 0, -16}, 32, 2)}));
  check_seen(
      subtract({outer, inner, with_transform("[[0,0,1,0],[0,1,0,0],[-1,0,0,0],[0,0,0,1]]", rod({0, 0, 0}, 32, 2))}));
}
TEST_CASE("crossing cylinders of equal radius are drawn correctly") {
  check_all_of(rod({0, 0, -8}, 16, 4), lying(rod({0, 0, -8}, 16, 4)));
}
TEST_CASE("ellipsoids that touch are drawn correctly") {
  check_all_of(with_transform(scaling({2, 1, 0.5}), ball({-4, 0, 0}, 4)),
               with_transform(scaling({0.5, 2, 1}), ball({8, 0, 0}, 8)));
}
