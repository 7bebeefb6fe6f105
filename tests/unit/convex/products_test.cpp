#include "host/convex/solid_products.h"
#include "tests/support/test.h"
#include "tests/unit/convex/support.h"

using namespace csgsim;
using testing::TestModel;

namespace {

std::vector<convex::SolidProduct> products(const TestModel& model) {
  std::vector<convex::SolidProduct> found;
  convex::for_each_product(model.scene, model.positive,
                           [&](convex::SolidProduct product) { found.push_back(std::move(product)); });
  return found;
}

std::string box(double x, double y, double size) {
  return fmt::format("multmatrix([[1,0,0,{}],[0,1,0,{}],[0,0,1,0],[0,0,0,1]]){{cube(size=[{},{},1],center=false);}}\n",
                     x, y, size, size);
}

std::string many(const char* op, int count, double step, double size) {
  std::string text = fmt::format("{}(){{\n", op);
  for (int i = 0; i < count; ++i) text += box(step * i, step * (i % 3), size);
  return text + "}\n";
}

}  // namespace

TEST_CASE("a product lists its primitive and the solids subtracted from it") {
  const TestModel model("difference(){union(){" + box(0, 0, 2) + box(1, 1, 2) + "}" + box(2.5, 2.5, 2) + box(9, 9, 1) +
                        "}");
  const std::vector<convex::SolidProduct> found = products(model);
  REQUIRE(found.size() == 2);
  CHECK(found[0].primitive == 0);
  CHECK(found[0].subtracted.empty());
  CHECK(found[1].primitive == 1);
  CHECK(found[1].subtracted == std::vector<std::uint32_t>{2});
}

TEST_CASE("intersected unions of disjoint solids are matched and not expanded") {
  // Expansion would give 40^8 products; only 40 are not empty.
  std::string text = "intersection(){\n";
  for (int i = 0; i < 8; ++i) text += many("union", 40, 2.0, 1.0 + 0.1 * i);
  const std::vector<convex::SolidProduct> found = products(TestModel(text + "}"));
  REQUIRE(found.size() == 40);
  for (const convex::SolidProduct& product : found) CHECK(convex::volume(product.whole) == doctest::Approx(1.0));
}

TEST_CASE("differences of disjoint intersections have no empty products") {
  // There are 2^60 products without spatial pruning, and 121 with it.
  std::string text = "difference(){cube(size=[400,400,1],center=false);\n";
  for (int i = 0; i < 60; ++i) {
    text += "intersection(){" + box(6.0 * i, 3, 4) + box(6.0 * i + 1, 4, 4) + "}\n";
  }
  const TestModel model(text + "}");
  const std::vector<convex::SolidProduct> found = products(model);
  CHECK(found.size() <= 121);
  double volume = 0;
  for (const convex::Piece& piece : model.pieces()) volume += convex::volume(piece.polytope);
  CHECK(volume == doctest::Approx(160000.0 - 60.0 * 9.0).epsilon(1e-9));
}

TEST_CASE("exponentially many products are rejected quickly and deep trees accepted") {
  std::string text = "intersection(){\n";
  for (int i = 0; i < 12; ++i) text += many("union", 12, 0.01, 1.0 + 0.001 * i);
  const TestModel hard(text + "}");
  CHECK(testing::error_of([&] { (void)products(hard); }) ==
        "expanding the model into products needs more than 1000000 choices of a union's operand; intersect or "
        "subtract fewer unions of solids that overlap");

  std::string deep = box(0, 0, 1);
  const auto depth = testing::cases<std::size_t>(3000, 500);
  for (std::size_t i = 1; i < depth; ++i)
    deep = fmt::format("union(){{{}{}}}\n", deep, box(2.0 * static_cast<double>(i), 0, 1));
  CHECK(products(TestModel(deep)).size() == depth);
}
