#include "tests/numerics/curved_case.h"
#include "tests/numerics/solids.h"
#include "tests/support/test.h"

using namespace csgsim::testing;

namespace {

CurvedLook on_all_engines() {
  CurvedLook how;
  how.engines = true;
  return how;
}

void check_seen(const std::string& csg, const CurvedLook& how = on_all_engines()) {
  const CurvedVerdict verdict = look_at_all(csg, how);
  CHECK(verdict.covered > 100);
  CHECK(verdict.wrong <= 4);
}

const std::string block = box({-6, -6, -6}, {6, 6, 6});
const std::string lens = intersect({ball({0, 0, 0}, 6), rod({1, 0, -8}, 16, 4), cylinder({0, 1, -7}, 14, 7, 0)});

/// A block with its corners cut off, in the form in which OpenSCAD prints a hull.
const std::string gem =
    "hull(){" + box({-5, -3, -3}, {5, 3, 3}) + box({-3, -5, -3}, {3, 5, 3}) + box({-3, -3, -5}, {3, 3, 5}) + "}\n";

}  // namespace

TEST_CASE("the intersection of a ball and a cylinder and a cone is drawn correctly") {
  check_seen(lens);
  check_seen(with_transform(rotation(40, 25), lens));
}
TEST_CASE("a block minus the common part of ball and cylinder and cone is drawn correctly") {
  check_seen(subtract({box({-6, -2, -6}, {6, 6, 6}), lens}));
  check_seen(subtract({box({-6, -2, -6}, {6, 6, 6}), with_transform(rotation(40, 25), lens)}));
}
TEST_CASE("the intersection of a ball and a cylinder and a cone is seen from inside") {
  CurvedLook how;
  how.near = 0.25;
  const CurvedVerdict verdict =
      look_curved(subtract({block, lens}), {{0.5, -1, 0.25}, {1, 4, 2}, Projection::perspective}, how);
  CHECK(verdict.inside >= 2);
  CHECK(verdict.covered > 200);
  look_curved(lens, {{0.5, -1, 0.25}, {1, 4, 2}, Projection::perspective}, how);
  look_curved(subtract({block, lens}), {{0.5, -1, 0.25}, {1, -4, -2}, Projection::perspective}, how);
}
TEST_CASE("the intersections of two balls and of three balls are drawn correctly") {
  check_seen(intersect({ball({-2, 0, 0}, 6), ball({2, 0, 0}, 6)}));
  check_seen(intersect({ball({-2, 0, 0}, 6), ball({2, 0, 0}, 6), ball({0, 1, 3}, 6)}));
}
TEST_CASE("holes that cross each other in a ball are open") {
  const std::string across = with_transform(rotation(90, 0), rod({0, 0, -8}, 16, 2));
  check_seen(subtract({ball({0, 0, 0}, 6), rod({0, 0, -8}, 16, 2), across, with_transform(rotation(0, 90), across)}));
}
TEST_CASE("a cube minus many balls is drawn correctly") {
  std::vector<std::string> parts{block};
  for (int i = 0; i < 12; ++i) {
    const int row = i / 3;
    parts.push_back(ball({(i % 3 - 1) * 4.0, -6 + row * 3.0, (i % 4 - 1.5) * 4.0}, 2.25));
  }
  CurvedLook how;
  check_seen(subtract(parts), how);
}
TEST_CASE("subtracting a drilled solid leaves the core of its hole") {
  check_seen(subtract({block, subtract({rod({0, 0, -8}, 16, 5), rod({0, 0, -9}, 18, 3)})}));
  check_seen(
      subtract({ball({0, 0, 0}, 6), subtract({ball({0, 0, 0}, 5), ball({0, -1, 0}, 3)}), box({0, -7, 0}, {7, 7, 7})}));
}
TEST_CASE("sheared cylinders and balls and cones are drawn correctly") {
  const std::string shear = "[[1,0.5,0.75,0],[0,1,-0.5,0],[0,0,1,0],[0,0,0,1]]";
  check_seen(with_transform(shear, rod({0, 0, -4}, 8, 4)));
  check_seen(with_transform(shear, ball({0, 0, 0}, 4)));
  check_seen(with_transform(shear, cylinder({0, 0, -4}, 8, 4, 0)));
  check_seen(with_transform(shear, subtract({rod({0, 0, -4}, 8, 4), rod({0, 0, -4}, 8, 2)})));
}
TEST_CASE("elliptic cones and frustums are drawn correctly") {
  const std::string cone = cylinder({0, 0, -4}, 8, 4, 0);
  check_seen(with_transform(scaling({2, 0.5, 1}), cone));
  check_seen(with_transform(rotation(100, 30), with_transform(scaling({2, 0.75, 1}), cone)));
  check_seen(subtract({block, with_transform(scaling({1.5, 0.75, 1.25}), cylinder({0, 0, -5}, 10, 4, 2))}));
}
TEST_CASE("mirrored curved solids are drawn correctly") {
  const std::string body = subtract({cylinder({0, 0, -4}, 8, 5, 2), rod({1, 0, -5}, 10, 1)});
  check_seen(with_transform(scaling({-1, 1, 1}), body));
  check_seen(with_transform(scaling({-1, -1, -1}), body));
}
TEST_CASE("a hull of boxes and a ball are combined correctly by all operators") {
  check_seen(unite({gem, ball({3, -3, 3}, 3)}));
  check_seen(subtract({gem, ball({3, -3, 3}, 3)}));
  check_seen(subtract({ball({0, 0, 0}, 6), gem}));
  check_seen(intersect({gem, ball({0, 0, 0}, 5)}));
}
TEST_CASE("a tetrahedron and a ball are combined correctly by all operators") {
  const std::string pyramid = tetrahedron({-6, -6, -6}, {6, 6, -6}, {-6, 6, 6}, {6, -6, 6});
  check_seen(unite({pyramid, ball({0, 0, 0}, 4)}));
  check_seen(subtract({pyramid, ball({0, 0, 0}, 4)}));
  check_seen(intersect({pyramid, ball({0, 0, 0}, 4)}));
}
TEST_CASE("cylinders of few sides next to round ones are drawn correctly") {
  const std::string prism = cylinder({0, 0, -4}, 8, 4, 4, 6);
  check_seen(unite({prism, rod({2, -2, -5}, 10, 2)}));
  check_seen(subtract({rod({0, 0, -3}, 6, 5), prism}));
  check_seen(intersect({prism, rod({0, 0, -5}, 10, 3.75)}));
}
TEST_CASE("a solid used twice is seen once and a copy elsewhere in the tree changes nothing") {
  const std::string body = subtract({ball({0, 0, 0}, 6), rod({0, 0, -8}, 16, 2)});
  check_seen(unite({body, body}));
  check_seen(intersect({body, body}));
  check_seen(subtract({body, subtract({body, body})}));
}
TEST_CASE("at equal depth of a solid's surfaces the first primitive is visible") {
  CurvedLook coarse;
  coarse.z_bits = 4;
  const std::string bowl = ball({0, 0, 0}, 4);
  for (const std::string& other : {box({-3, -3, -3}, {3, 3, 3}), rod({0, 0, -3}, 6, 3), gem}) {
    look_at_all(intersect({bowl, other}), coarse);
    look_at_all(intersect({other, bowl}), coarse);
    look_at_all(intersect({rod({0, 0, -5}, 10, 3.5), other, bowl}), coarse);
  }
}
TEST_CASE("colours of curved solids are equal on all machines and where surfaces meet") {
  const std::string red = "color([0.9,0.2,0.1,1]){" + ball({0, 0, 0}, 5) + "}\n";
  const std::string blue = "color([0.1,0.3,0.9,1]){" + rod({0, 0, -7}, 14, 3) + "}\n";
  check_seen(unite({red, blue}));
  check_seen(subtract({red, blue}));
  check_seen(intersect({blue, red}));
}
