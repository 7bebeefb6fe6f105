#include "host/convex/pieces.h"

#include "host/convex/clip.h"
#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using testing::TestModel;

namespace {

double total_volume(const std::vector<convex::Piece>& pieces) {
  double sum = 0;
  for (const convex::Piece& piece : pieces) sum += convex::volume(piece.polytope);
  return sum;
}

/// Checks that random points lie in the model exactly if they lie in a piece, in at most one of each product, and in
/// that piece's primitive. Returns the number of points inside.
int check_points(const TestModel& model, const std::vector<convex::Piece>& pieces, testing::RandomPoints& random,
                 int count) {
  int inside = 0;
  facet::Box box;
  for (const facet::Convex& solid : model.scene.solids) box = hull(box, solid.box);
  for (int i = 0; i < count && !box.empty(); ++i) {
    const glm::dvec3 point = random.around(model.scene.box.empty() || i % 4 == 0 ? box : model.scene.box);
    const std::optional<bool> expected = testing::contains_point(model, point);
    if (!expected) continue;
    std::set<std::uint32_t> products;
    for (const convex::Piece& piece : pieces) {
      if (testing::signed_distance(model.scene, piece.polytope, point) >= 0.0) continue;
      REQUIRE(products.insert(piece.product).second);
      for (const facet::Face& face : model.solids[piece.primitive].faces) {
        REQUIRE(glm::dot(face.plane.normal, point) + face.plane.offset < 0.0);
      }
    }
    REQUIRE(products.empty() != *expected);
    if (*expected) ++inside;
  }
  return inside;
}

std::string box(double x, double y, double z, double a, double b, double c) {
  return fmt::format(
      "multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{cube(size=[{},{},{}],center=false);}}\n", x, y, z, a,
      b, c);
}

std::string ball(double x, double y, double z, double radius, int count) {
  return fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,{}],[0,0,0,1]]){{sphere($fn={},$fa=12,$fs=2,r={});}}\n",
                     x, y, z, count, radius);
}

}  // namespace

TEST_CASE("a point is in a random model exactly if one piece of a product contains it") {
  testing::RandomPoints random(11);
  int inside = 0;
  for (std::uint64_t seed = 0; seed < 1200; ++seed) {
    CAPTURE(seed);
    const TestModel model(testing::random_model(seed, 1 + static_cast<unsigned>(seed % 12)));
    const std::vector<convex::Piece> pieces = model.pieces();
    for (const convex::Piece& piece : pieces) {
      REQUIRE(!piece.polytope.empty());
      REQUIRE(testing::describe_flaws(model.scene, piece.polytope) == "");
    }
    inside += check_points(model, pieces, random, 250);
  }
  CHECK(inside > 5000);
}

TEST_CASE("a point is in a demo model exactly if a piece contains it") {
  testing::RandomPoints random(12);
  for (const char* name : {"thesis_fig_2_3", "carburettor", "terrain_vehicle", "rietveld_house", "basics_csg",
                           "old_example002", "old_example003", "old_example011"}) {
    CAPTURE(name);
    const TestModel model = testing::demo_model(name);
    const std::vector<convex::Piece> pieces = model.pieces();
    for (const convex::Piece& piece : pieces) REQUIRE(testing::describe_flaws(model.scene, piece.polytope) == "");
    CHECK(check_points(model, pieces, random, 3000) > 20);
  }
}

TEST_CASE("pieces of a product have the remaining volume") {
  const TestModel notched("difference(){" + box(0, 0, 0, 4, 4, 4) + box(2, 2, 2, 4, 4, 4) + "}");
  CHECK(notched.pieces().size() == 3);
  CHECK(total_volume(notched.pieces()) == doctest::Approx(56.0).epsilon(1e-12));

  const TestModel hollow("difference(){" + box(0, 0, 0, 4, 4, 4) + box(1, 1, 1, 2, 2, 2) + "}");
  CHECK(hollow.pieces().size() == 6);
  CHECK(total_volume(hollow.pieces()) == doctest::Approx(56.0).epsilon(1e-12));

  const TestModel drilled("difference(){" + box(0, 0, 0, 4, 4, 4) + box(1, 1, -1, 2, 2, 9) + "}");
  CHECK(drilled.pieces().size() == 4);
  CHECK(total_volume(drilled.pieces()) == doctest::Approx(48.0).epsilon(1e-12));

  const TestModel twice("difference(){" + box(0, 0, 0, 4, 4, 4) + box(1, 1, -1, 2, 2, 9) + box(-1, 1, 1, 9, 2, 2) +
                        "}");
  CHECK(total_volume(twice.pieces()) == doctest::Approx(64.0 - 16.0 - 16.0 + 8.0).epsilon(1e-12));

  // Subtracting a sphere from another removes their intersection.
  const TestModel dented("difference(){" + ball(0, 0, 0, 3, 12) + ball(2, 1, 0, 2, 14) + "}");
  const TestModel both("intersection(){" + ball(0, 0, 0, 3, 12) + ball(2, 1, 0, 2, 14) + "}");
  const TestModel one(ball(0, 0, 0, 3, 12));
  CHECK(total_volume(dented.pieces()) ==
        doctest::Approx(total_volume(one.pieces()) - total_volume(both.pieces())).epsilon(1e-11));
}

TEST_CASE("a solid that nothing cuts is one piece and a removed solid has none") {
  CHECK(TestModel("difference(){" + box(0, 0, 0, 2, 2, 2) + box(2, 0, 0, 2, 2, 2) + "}").pieces().size() == 1);
  CHECK(TestModel("difference(){" + box(0, 0, 0, 2, 2, 2) + box(0, 0, 0, 2, 2, 2) + "}").pieces().empty());
  CHECK(TestModel("intersection(){" + box(0, 0, 0, 2, 2, 2) + box(2, 0, 0, 2, 2, 2) + "}").pieces().empty());
  CHECK(TestModel(model::Tree{}).pieces().empty());
  // The bounding boxes overlap but the solids do not.
  const TestModel beside("difference(){" + box(0, 0, 0, 2, 2, 2) + ball(3, 3, 1, 1.3, 40) + "}");
  CHECK(beside.pieces().size() == 1);
}

TEST_CASE("half-spaces that do not bound the subtracted region cut no pieces") {
  // Only one of the six half-spaces separates the subtracted region from the rest.
  const TestModel model("difference(){" + box(0, 0, 0, 4, 4, 4) + box(3, -1, -1, 9, 9, 9) + "}");
  CHECK(model.pieces().size() == 1);
  CHECK(total_volume(model.pieces()) == doctest::Approx(48.0).epsilon(1e-12));
}

TEST_CASE("fifty dimples in a plate are one product") {
  std::string text = "difference(){" + box(0, 0, 0, 50, 25, 2);
  for (int row = 0; row < 5; ++row) {
    for (int column = 0; column < 10; ++column) text += ball(2.5 + 5.0 * column, 2.5 + 5.0 * row, 2.5, 1.5, 12);
  }
  const TestModel model(text + "}");
  const std::vector<convex::Piece> pieces = model.pieces();
  CHECK(pieces.back().product == 0);
  CHECK(pieces.size() < 6000);
  const TestModel dimple("intersection(){" + box(0, 0, 0, 5, 5, 2) + ball(2.5, 2.5, 2.5, 1.5, 12) + "}");
  CHECK(total_volume(pieces) == doctest::Approx(2500.0 - 50.0 * total_volume(dimple.pieces())).epsilon(1e-10));
}

TEST_CASE("rejects a model with more pieces than the limit and suggests a fix") {
  const TestModel model("difference(){" + box(0, 0, 0, 4, 4, 4) + ball(2, 2, 2, 1, 20) + "}");
  CHECK(convex::pieces(model.scene, model.positive, 400).size() == 182);
  CHECK(testing::error_of([&] { (void)convex::pieces(model.scene, model.positive, 100); }) ==
        "the model needs more than 100 convex pieces; use fewer facets ($fn) for the subtracted solids, or "
        "subtract fewer");
}
