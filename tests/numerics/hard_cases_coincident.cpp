#include "tests/numerics/hard_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

const std::string left = box({0, 0, 0}, {10, 10, 10});
const std::string right = box({10, 0, 0}, {20, 10, 10});
const std::string upper_right = box({10, 3, 2}, {16, 10, 10});

/// Checks that the model is visible and correct at every pixel.
void check_seen(const std::string& csg) {
  const Verdict verdict = look_around(csg);
  CHECK(verdict.wrong == 0);
  CHECK(verdict.covered > 1000);
}

/// Checks that the model is empty.
void check_empty(const std::string& csg) {
  // A separate box keeps the picture from being empty.
  const Verdict with = look_around(unite({csg, box({30, 30, 30}, {31, 31, 31})}));
  CHECK(with.wrong == 0);
  const Verdict alone = look_around(csg);
  CHECK(alone.wrong == 0);
  CHECK(alone.covered == 0);
}

}  // namespace

TEST_CASE("a solid minus itself is empty") {
  check_empty(subtract({left, left}));
  check_empty(subtract({cylinder({0, 0, 0}, 9, 5, 5, 17), cylinder({0, 0, 0}, 9, 5, 5, 17)}));
  check_empty(subtract({ball({1, 2, 3}, 5, 12), ball({1, 2, 3}, 5, 12)}));
}
TEST_CASE("a solid united or intersected with itself is itself and the first copy owns it") {
  check_seen(unite({left, left}));
  check_seen(intersect({ball({0, 0, 0}, 5, 14), ball({0, 0, 0}, 5, 14)}));
}
TEST_CASE("a union of boxes with a common face shows no seam") { check_seen(unite({left, right})); }
TEST_CASE("a union of boxes with a partly common face shows no seam") { check_seen(unite({left, upper_right})); }
TEST_CASE("boxes that touch do not intersect") {
  check_empty(intersect({left, right}));
  check_empty(intersect({left, upper_right}));
}
TEST_CASE("a box minus one that touches it is unchanged") { check_seen(subtract({left, right})); }
TEST_CASE("coincident faces of a union belong to the first solid") {
  check_seen(unite({box({0, 0, 0}, {10, 10, 10}), box({2, 0, 3}, {8, 7, 13})}));
  check_seen(unite({box({2, 0, 3}, {8, 7, 13}), box({0, 0, 0}, {10, 10, 10})}));
}
TEST_CASE("coincident faces of an intersection belong to the first solid") {
  check_seen(intersect({box({0, 0, 0}, {10, 10, 10}), box({2, 0, 3}, {18, 7, 10})}));
}
TEST_CASE("a cut that ends flush with the front face leaves no membrane") {
  check_seen(subtract({left, box({2, 0, 2}, {8, 5, 8})}));
}
TEST_CASE("a cut that ends flush with the back face leaves no membrane") {
  check_seen(subtract({left, box({2, 5, 2}, {8, 10, 8})}));
}
TEST_CASE("a cut that ends flush with a side face leaves no membrane") {
  check_seen(subtract({left, box({5, 2, 2}, {10, 8, 8})}));
  check_seen(subtract({left, box({2, 2, 5}, {8, 8, 10})}));
}
TEST_CASE("a hole whose ends are flush with both faces is open") {
  check_seen(subtract({left, box({3, 0, 3}, {7, 10, 7})}));
  check_seen(subtract({cylinder({0, 0, 0}, 6, 8, 8, 24), cylinder({0, 0, 0}, 6, 4, 4, 24)}));
  check_seen(subtract({left, cylinder({5, 5, 0}, 10, 3, 3, 9)}));
}
TEST_CASE("three holes along the axes that cross each other are open") {
  const Verdict verdict =
      look_around(subtract({left, box({3, 0, 3}, {7, 10, 7}), box({0, 3, 3}, {10, 7, 7}), box({3, 3, 0}, {7, 7, 10})}));
  // Seen along the axis in perspective, four pixel centres are on the edges between two walls, at the same depth.
  CHECK(verdict.wrong <= 4);
  CHECK(verdict.covered > 1000);
}
TEST_CASE("a box minus both of its halves is empty") {
  check_empty(subtract({box({0, 0, 0}, {20, 10, 10}), left, right}));
}
TEST_CASE("many boxes with coplanar faces are combined correctly") {
  std::vector<std::string> boxes;
  for (int i = 0; i < 6; ++i) boxes.push_back(box({2.0 * i, 0, 0}, {2.0 * i + 3.0, 4.0 + (i % 3), 5}));
  check_seen(unite(boxes));
  boxes.insert(boxes.begin(), box({-1, 0, 0}, {15, 6, 5}));
  check_seen(subtract(boxes));
  const std::string half = intersect({unite(std::span(boxes).subspan(1)), box({0, 0, 0}, {15, 3, 5})});
  check_seen(half);
}
TEST_CASE("cylinders of equal radius end to end are one cylinder") {
  check_seen(unite({cylinder({0, 0, 0}, 5, 4, 4, 15), cylinder({0, 0, 5}, 5, 4, 4, 15)}));
  check_seen(subtract({cylinder({0, 0, 0}, 10, 4, 4, 15), cylinder({0, 0, 5}, 5, 4, 4, 15)}));
}
TEST_CASE("a cone that continues a cone of the same slope is one cone") {
  check_seen(unite({cylinder({0, 0, 0}, 4, 8, 6, 13), cylinder({0, 0, 4}, 4, 6, 4, 13)}));
}
TEST_CASE("faces made coincident by different chains of transforms remain coincident") {
  const std::string there = rotation(33, 71);
  const std::string one = with_transform(there, left);
  // The same placement as a product of three matrices: back by its height and forth again.
  const std::string other = with_transform(
      there, with_transform(translation({0.1, 0.2, 0.3}), with_transform(translation({-0.1, -0.2, -0.3}), left)));
  check_empty(subtract({one, other}));
  check_seen(unite({other, with_transform(there, right)}));
}
