#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

void check_seen(const std::string& csg) {
  const Verdict verdict = look_around(csg);
  CHECK(verdict.wrong == 0);
  CHECK(verdict.covered > 1000);
}

void check_empty(const std::string& csg) {
  const Verdict verdict = look_around(csg);
  CHECK(verdict.wrong == 0);
  CHECK(verdict.covered == 0);
}

const std::string one = box({0, 0, 0}, {8, 8, 8});

}  // namespace

TEST_CASE("a union of cubes that share an edge is drawn correctly") {
  check_seen(unite({one, box({8, 8, 0}, {16, 16, 8})}));
  check_seen(unite({one, box({8, 0, 8}, {16, 8, 16})}));
}
TEST_CASE("cubes that share an edge do not intersect") {
  check_empty(intersect({one, box({8, 8, 0}, {16, 16, 8})}));
  check_empty(intersect({one, box({0, 8, 8}, {8, 16, 16})}));
}
TEST_CASE("cubes that share a vertex are united correctly and do not intersect") {
  const std::string other = box({8, 8, 8}, {16, 16, 16});
  check_seen(unite({one, other}));
  check_empty(intersect({one, other}));
  check_seen(subtract({one, other}));
}
TEST_CASE("four cubes around a common edge leave no crack") {
  check_seen(unite({one, box({8, 0, 0}, {16, 8, 8}), box({0, 8, 0}, {8, 16, 8}), box({8, 8, 0}, {16, 16, 8})}));
}
TEST_CASE("eight cubes around a common vertex leave no crack") {
  std::vector<std::string> cubes;
  for (unsigned i = 0; i < 8; ++i) {
    const glm::dvec3 low((i & 1U) != 0 ? 8 : 0, (i & 2U) != 0 ? 8 : 0, (i & 4U) != 0 ? 8 : 0);
    cubes.push_back(box(low, low + 8.0));
  }
  check_seen(unite(cubes));
  // A block minus all of them is empty.
  cubes.insert(cubes.begin(), box({0, 0, 0}, {16, 16, 16}));
  check_empty(subtract(cubes));
}
TEST_CASE("three planes of different solids with a common line are classified correctly") {
  // The faces x = 8, z = 8 and x = z all contain the line x = z = 8.
  const std::string wedge = with_transform(
      "[[0.70710678118654757,0,-0.70710678118654757,8],[0,1,0,0],[0.70710678118654757,0,0.70710678118654757,8],"
      "[0,0,0,1]]",
      box({-6, 0, 0}, {6, 8, 6}));
  check_seen(unite({one, wedge}));
  check_seen(subtract({box({0, 0, 0}, {12, 8, 12}), one, wedge}));
  check_seen(intersect({box({0, 0, 0}, {12, 8, 12}), unite({one, wedge})}));
}
TEST_CASE("a box whose vertex touches another box's face leaves no mark on it") {
  const std::string corner = with_transform(
      translation({4, 0, 4}), with_transform(rotation(35.264389682754654, 45), box({0, 0, 0}, {4, 4, 4})));
  const Verdict verdict = look_obliquely(subtract({one, corner}));
  CHECK(verdict.wrong == 0);
  CHECK(verdict.covered > 1000);
}
TEST_CASE("an edge that lies in another solid's face leaves no mark on it") {
  const std::string roof = with_transform(
      "[[0.70710678118654757,0,-0.70710678118654757,4],[0,1,0,0],[0.70710678118654757,0,0.70710678118654757,8],"
      "[0,0,0,1]]",
      box({0, 1, 0}, {4, 7, 4}));
  check_seen(unite({one, roof}));
  check_seen(subtract({one, roof}));
}
TEST_CASE("a prism inscribed in a prism touches it along edges") {
  // Every second edge of the hexagon is an edge of the triangle.
  const std::string hexagon = cylinder({0, 0, 0}, 8, 8, 8, 6);
  const std::string triangle = cylinder({0, 0, 0}, 8, 8, 8, 3);
  check_seen(unite({hexagon, triangle}));
  check_seen(subtract({hexagon, triangle}));
  check_empty(subtract({triangle, hexagon}));
}
