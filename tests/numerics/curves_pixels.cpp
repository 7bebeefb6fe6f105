#include "host/view/camera.h"
#include "tests/numerics/curved_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

constexpr std::uint32_t height = 33;

/// An eye on the y axis at the distance where a pixel is one model unit at the origin, in perspective.
glm::dvec3 eye() { return {0, -(height / 2.0) / csgsim::view::half_height_per_distance(), 0}; }

/// Tolerates wrong pixels on outlines, which pass pixel centres within rounding errors of doubles.
CurvedVerdict look_straight(const std::string& csg) {
  const CurvedVerdict verdict = look_both_ways(csg, eye(), {0, 0, 0});
  CHECK(verdict.wrong <= 30 + verdict.covered / 2);
  return verdict;
}

}  // namespace

TEST_CASE("a ball with its outline through the middle pixel's centre is drawn correctly") {
  for (const glm::dvec3& centre : {glm::dvec3(8, 0, 0), {-8, 0, 0}, {0, 0, 8}, {0, 0, -8}}) {
    CHECK(look_straight(ball(centre, 8)).covered > 100);
    CHECK(look_straight(subtract({box({-20, 0, -16}, {20, 16, 16}), ball(centre, 8)})).covered > 100);
  }
}
TEST_CASE("a ball with its outline on pixel centres at 3-4-5 offsets is drawn correctly") {
  for (const double radius : {5.0, 10.0, 13.0, 15.0}) CHECK(look_straight(ball({0, 0, 0}, radius)).covered > 50);
}
TEST_CASE("a ball with its outline close to pixel centres is drawn correctly") {
  for (const double off : {1e-12, 1e-9, 1e-6, 1e-4, 1e-2}) {
    look_straight(ball({0, 0, 0}, 10 + off));
    look_straight(ball({0, 0, 0}, 10 - off));
    look_straight(ball({10 + off, 0, 0}, 10));
    look_straight(ball({10 - off, 0, 0}, 10));
  }
}
TEST_CASE("cylinders with outlines along columns of pixel centres are drawn correctly") {
  for (const double radius : {1.0, 4.0, 7.5}) {
    look_straight(cylinder({radius, 0, -8}, 16, radius, radius));
    look_straight(cylinder({0, 0, -8}, 16, radius, radius));
    look_straight(subtract({box({-9, 0, -9}, {9, 9, 9}), cylinder({radius, 0, -8}, 16, radius, radius)}));
  }
}
TEST_CASE("a cone with its apex on a pixel centre is drawn correctly in all directions") {
  const std::string up = cylinder({0, 0, -8}, 8, 4, 0);
  const std::string down = cylinder({0, 0, 0}, 8, 0, 4);
  const std::string off = with_transform(translation({3, 0, 5}), up);
  for (const std::string& cone :
       {up, down, off, with_transform(rotation(90, 0), up), with_transform(rotation(-90, 0), up),
        with_transform(rotation(0, 90), with_transform(rotation(90, 0), up))}) {
    look_straight(cone);
    look_straight(subtract({box({-9, -9, -9}, {9, 9, 9}), cone}));
  }
}
TEST_CASE("two cones that share an apex on a pixel centre are drawn correctly") {
  const std::string both = unite({cylinder({0, 0, -8}, 8, 4, 0), cylinder({0, 0, 0}, 8, 0, 4)});
  look_straight(both);
  look_straight(subtract({box({-9, 0, -9}, {9, 9, 9}), both}));
}
TEST_CASE("concentric balls with outlines on neighbouring pixel centres keep their order") {
  look_straight(unite({ball({0, 0, 0}, 8), ball({0, 4, 0}, 9), ball({0, 8, 0}, 10)}));
  look_straight(subtract({ball({0, 8, 0}, 12), ball({0, 0, 0}, 8), ball({0, 0, 0}, 9)}));
}
TEST_CASE("plane cuts through a ball's middle on pixel centres are drawn correctly") {
  look_straight(subtract({ball({0, 0, 0}, 8), box({0, -9, -9}, {9, 9, 9})}));
  look_straight(intersect({ball({0, 0, 0}, 8), box({-9, -9, 0}, {9, 9, 9})}));
  look_straight(intersect({ball({0, 0, 0}, 8), box({-9, 0, -9}, {9, 9, 9})}));
}
TEST_CASE("a picture of even size shows symmetric models symmetrically") {
  CurvedLook how;
  how.width = 40;
  how.height = 32;
  look_both_ways(ball({0, 0, 0}, 8), {0, -60, 0}, {0, 0, 0}, how);
  look_both_ways(cylinder({0, 0, -6}, 12, 4, 4), {0, -60, 0}, {0, 0, 0}, how);
}
