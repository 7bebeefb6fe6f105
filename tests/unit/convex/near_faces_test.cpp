#include "host/convex/near_faces.h"

#include <rapidcheck.h>

#include "tests/support/test.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using testing::TestModel;

namespace {

convex::NearFaces near_faces(const std::string& text) {
  const TestModel model(text);
  return convex::near_faces(model.tree, model.scene);
}

std::string box(double x, double y, double z, double size) {
  return fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]) {{ cube(size = {}); }}\n", x, y, z,
                     size);
}

std::string turned(const std::string& cosine, const std::string& sine, const std::string& what) {
  return fmt::format("multmatrix([[{0},-{1},0,0],[{1},{0},0,0],[0,0,1,0],[0,0,0,1]]) {{ {2} }}\n", cosine, sine, what);
}

/// A cube rotated by 60, 30 and 30 degrees with matrices of six digits.
std::string thrice_turned(const std::string& what) {
  return turned("0.5", "0.866025", turned("0.866025", "0.5", turned("0.866025", "0.5", what)));
}

}  // namespace

TEST_CASE("faces aligned by different six-digit rotations are near but not the same") {
  const std::string once = turned("-0.5", "0.866025", "cube(size = [3, 5, 7], center = true);");
  const convex::NearFaces found =
      near_faces("difference() {\n" + once + thrice_turned("cube(size = [3, 5, 7], center = true);") + "}");
  CHECK(found.pairs == 1);
  CHECK_FALSE(found.is_incomplete);
  CHECK(found.first == std::array<std::uint32_t, 2>{0, 1});
}

TEST_CASE("coplanar faces and clearly separate faces are not near") {
  CHECK(near_faces(box(0, 0, 0, 10) + box(10, 0, 0, 10)).pairs == 0);
  CHECK(near_faces(box(0, 0, 0, 10) + box(10.001, 0, 0, 10)).pairs == 0);
  CHECK(near_faces("difference() {" + box(0, 0, 0, 10) + box(2, 2, -0.001, 10.001) + "}").pairs == 0);
}

TEST_CASE("parallel faces within the resolution of twenty bits are near") {
  CHECK(near_faces(box(0, 0, 0, 10) + box(10.00001, 0, 0, 10)).pairs == 1);
  CHECK(near_faces("difference() {" + box(0, 0, 0, 10) + box(2, 2, -0.00001, 10) + "}").pairs == 1);
}

TEST_CASE("faces in near planes that do not overlap are not near") {
  CHECK(near_faces(box(0, 0, 0, 10) + box(30, 0, 0.00001, 10)).pairs == 0);
  CHECK(near_faces(box(0, 0, 0, 10) + box(10, 0, 0.00001, 10)).pairs == 0);
}

TEST_CASE("a pair of nodes with near faces counts once and the first in the file is named") {
  const convex::NearFaces found =
      near_faces(box(50, 0, 0, 1) + box(0, 0, 0, 10) + box(10.00001, 0, 0, 10) + box(20.00002, 0, 0, 10));
  CHECK(found.pairs == 2);
  CHECK(found.first == std::array<std::uint32_t, 2>{1, 2});
}

TEST_CASE("normals on both sides of the canonical sign change are near") {
  // Canonical normals are (e, 1, 0) and (e, -1, 0).
  const auto tilted = [](double by, double y) {
    return fmt::format("multmatrix([[1,{0},0,0],[{1},1,0,{2}],[0,0,1,0],[0,0,0,1]]) {{ cube(size = 10); }}\n", by, -by,
                       y);
  };
  CHECK(near_faces(tilted(1e-6, 0) + tilted(-1e-6, 10)).pairs == 1);
}

TEST_CASE("pieces of one node are not compared with each other") {
  CHECK(near_faces("linear_extrude(height = 5) { polygon(points = [[0,0],[10,0],[10,10],[5,10.00001],[0,10]], paths = "
                   "undef); }")
            .pairs == 0);
}

TEST_CASE("the search for near faces reports that it stopped at too many") {
  std::string text;
  for (int i = 0; i < 1100; ++i) text += box(20 * i, 0, 0, 10) + box(20 * i, 50, 10.00001, 10);
  CHECK(near_faces(text).is_incomplete);
}

TEST_CASE("near pairs of many boxes match pairwise comparisons") {
  CHECK(rc::check([] {
    // Corners that coincide, are near, or are apart.
    const auto coordinate = [] {
      const double whole = *rc::gen::inRange(0, 3);
      return 5.0 * whole + 1e-5 * *rc::gen::inRange(-1, 2);
    };
    std::vector<std::string> boxes;
    for (int i = 0; i < 8; ++i) {
      const double x = coordinate();
      const double y = coordinate();
      boxes.push_back(box(x, y, coordinate(), 5));
    }
    // Two distant boxes give all models the same size.
    const std::string far = box(-100, -100, -100, 1) + box(200, 200, 200, 1);
    std::string all = far;
    for (const std::string& one : boxes) all += one;
    std::uint64_t pairs = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t j = i + 1; j < boxes.size(); ++j) pairs += near_faces(far + boxes[i] + boxes[j]).pairs;
    }
    RC_ASSERT(near_faces(all).pairs == pairs);
  }));
}
