#include "host/convex/extent.h"

#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using testing::TestModel;

namespace {

constexpr const char* cube = "cube(size = 10, center = false);";

facet::Box extent(const std::string& text, std::size_t most = convex::max_extent_cuts) {
  const TestModel model(text);
  return convex::extent(model.scene, model.positive, most);
}

std::string moved(double x, double y, double z, const std::string& what) {
  return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0," + std::to_string(y) + "],[0,0,1," + std::to_string(z) +
         "],[0,0,0,1]]) {" + what + "}";
}

void check_near(const facet::Box& box, const glm::dvec3& low, const glm::dvec3& high) {
  for (int axis = 0; axis < 3; ++axis) {
    CHECK(box.low[axis] == doctest::Approx(low[axis]).epsilon(1e-9));
    CHECK(box.high[axis] == doctest::Approx(high[axis]).epsilon(1e-9));
  }
}

/// Bounding box of all pieces, which are computed completely.
facet::Box of_pieces(const TestModel& model) {
  facet::Box box;
  for (const convex::Piece& piece : model.pieces()) box = hull(box, convex::box_of(piece.polytope));
  return box;
}

}  // namespace

TEST_CASE("a model's extent excludes what a difference cuts off a side") {
  check_near(extent("difference() {" + std::string(cube) + moved(4, -1, -1, "cube(size = 12, center = false);") + "}"),
             {0, 0, 0}, {4, 10, 10});
}

TEST_CASE("a model's extent excludes what several solids cut off together") {
  const std::string cutters = moved(4, -1, -1, "cube(size = [12, 6, 12], center = false);") +
                              moved(6, 4, -1, "cube(size = [12, 12, 12], center = false);");
  check_near(extent("difference() {" + std::string(cube) + cutters + "}"), {0, 0, 0}, {6, 10, 10});
}

TEST_CASE("a hole leaves a model's extent unchanged to the last bit") {
  const TestModel model("difference() {" + std::string(cube) + moved(1.1, 1.3, -1, "cube(size = 3, center = false);") +
                        "}");
  const facet::Box box = convex::extent(model.scene, model.positive);
  CHECK(box.low == model.scene.box.low);
  CHECK(box.high == model.scene.box.high);
}

TEST_CASE("the extent of a random model is the box of its pieces") {
  int tighter = 0;
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const TestModel model(testing::random_model(seed, 1 + static_cast<unsigned>(seed % 12)));
    const facet::Box found = convex::extent(model.scene, model.positive);
    const facet::Box pieces = of_pieces(model);
    if (pieces.empty()) continue;
    const double slack = 1e-8 * model.scene.planes.diagonal();
    const glm::dvec3 centre = model.scene.planes.centre();
    for (int axis = 0; axis < 3; ++axis) {
      REQUIRE(std::abs(found.low[axis] - (pieces.low[axis] + centre[axis])) <= slack);
      REQUIRE(std::abs(found.high[axis] - (pieces.high[axis] + centre[axis])) <= slack);
    }
    if (glm::length(found.high - found.low) < 0.99 * glm::length(model.scene.box.high - model.scene.box.low)) ++tighter;
  }
  CHECK(tighter > 20);
}

TEST_CASE("an extent computed with a limited number of cuts is never too small") {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const TestModel model(testing::random_model(seed, 12));
    const facet::Box whole = convex::extent(model.scene, model.positive);
    const facet::Box quick = convex::extent(model.scene, model.positive, 3);
    const double slack = 1e-9 * model.scene.planes.diagonal();
    for (int axis = 0; axis < 3 && !whole.empty(); ++axis) {
      REQUIRE(quick.low[axis] <= whole.low[axis] + slack);
      REQUIRE(quick.high[axis] >= whole.high[axis] - slack);
    }
  }
}

TEST_CASE("an empty model keeps the box of its solids") {
  const facet::Box box = extent("difference() {" + std::string(cube) + cube + "}");
  CHECK(box.low == glm::dvec3(0));
  CHECK(box.high == glm::dvec3(10));
}

TEST_CASE("an extent beyond the work limit is the box of the whole scene") {
  // The subtraction removes all corners on one side of the cube, but less than half of its volume.
  const TestModel model(
      "difference() { cube(size = [10, 10, 10], center = true);"
      " multmatrix([[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,1]]) { cube(size = [10, 12, 12], center = true); } }");
  CHECK(convex::extent(model.scene, model.positive).high.x == doctest::Approx(-1));
  CHECK(convex::extent(model.scene, model.positive, convex::max_extent_cuts, 100).high.x == doctest::Approx(5));
}
