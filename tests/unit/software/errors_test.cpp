#include "host/facet/geometry.h"
#include "sim/software/methods/rows.h"
#include "tests/support/software_ways.h"
#include "tests/support/test.h"
#include "tests/unit/software/random_tree.h"
#include "tests/unit/software/scenes.h"

using namespace csgsim;
using testing::error_of;
using testing::Scene;
using testing::SoftwareScene;

namespace {

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// A cube in the middle of the picture, and a chain of operators with other cubes far from it.
Scene chain_of_cubes(unsigned primitives) {
  model::Tree tree = testing::chain(primitives);
  for (std::uint32_t i = 1; i < primitives; ++i) tree.primitives[i].transform[3] = {50, 0, 0, 1};
  view::Sampling sampling;
  sampling.width = 9;
  sampling.height = 9;
  return testing::make_scene(std::move(tree), {{0.5, -12, 0.5}, {0.5, 0, 0.5}, view::Projection::orthographic},
                             sampling);
}

std::string error_of_way(const SoftwareScene& software, const std::string& way,
                         software::Shape shape = software::Shape::written) {
  return error_of([&] {
    const std::unique_ptr<software::Method> method =
        software.make(testing::variant_named(way, software::Pruning::none, shape), true);
    CHECK(method != nullptr);
  });
}

void check_draws_the_cube(const SoftwareScene& software, const std::string& way) {
  CAPTURE(way);
  const software::Picture picture = software.draw(testing::variant_named(way));
  CHECK(picture.seen[9 * 4 + 4].owner == 0);
  CHECK(picture.seen.front().owner == software::VisibleSurface::nothing_seen);
}

}  // namespace

TEST_CASE("bit-parallel accepts a tree of 20 levels and rejects one of 21") {
  const Scene low = chain_of_cubes(21);
  const Scene high = chain_of_cubes(22);
  const SoftwareScene of_20(low.tree, low.geometry, low.view);
  const SoftwareScene of_21(high.tree, high.geometry, high.view);
  REQUIRE(of_20.tree(software::Shape::written).depth() == 20);
  for (const std::string way : {"bit-parallel", "bit-parallel-status"}) {
    check_draws_the_cube(of_20, way);
    CHECK(contains(error_of_way(of_21, way), "21 levels"));
    CHECK(contains(error_of_way(of_21, way), "--shapes balanced"));
  }
  for (const std::string way : {"standard", "early-out", "positional", "status", "bit-sequential", "interval-lists",
                                "weave", "interval-arithmetic"})
    check_draws_the_cube(of_21, way);
}
TEST_CASE("bit-parallel methods accept a balanced union of 23 solids but no chain of them") {
  Scene scene = chain_of_cubes(23);
  for (model::Node& node : scene.tree.nodes) node.op = model::Operator::unite;
  const SoftwareScene software(scene.tree, scene.geometry, scene.view);
  for (const std::string way : {"bit-parallel", "bit-parallel-status"}) {
    CHECK(contains(error_of_way(software, way, software::Shape::left_deep), "22 levels"));
    CHECK(error_of_way(software, way, software::Shape::balanced) == "");
  }
}
TEST_CASE("only recursive traversals reject a tree of 30000 levels") {
  const Scene scene = chain_of_cubes(30'001);
  const SoftwareScene software(scene.tree, scene.geometry, scene.view);
  for (const std::string way :
       {"standard", "early-out", "positional", "interval-lists", "weave", "interval-arithmetic"}) {
    CAPTURE(way);
    CHECK(contains(error_of_way(software, way), "the tree has 30000 levels"));
    CHECK(contains(error_of_way(software, way), "--shapes balanced"));
  }
  for (const std::string way : {"status", "bit-sequential"}) check_draws_the_cube(software, way);
}
TEST_CASE("recursive traversals draw a tree of 19000 levels") {
  const Scene scene = chain_of_cubes(19'001);
  const SoftwareScene software(scene.tree, scene.geometry, scene.view);
  for (const std::string way :
       {"standard", "early-out", "positional", "interval-lists", "weave", "interval-arithmetic"})
    check_draws_the_cube(software, way);
}
TEST_CASE("a software method and its coherence are selected by name") {
  for (const testing::MethodVariant& way : testing::all_variants()) {
    const software::Choice choice = software::choice_of(software::name_of(way.choice));
    CHECK(choice.method == way.choice.method);
    CHECK(choice.coherence == way.choice.coherence);
  }
  CHECK(software::name_of(software::choice_of("status")) == "status/all-points");
  CHECK(software::name_of(software::choice_of("weave")) == "weave");
}
TEST_CASE("an unknown method or coherence is rejected with a list of the valid ones") {
  const auto message = [](const std::string& text) { return error_of([&] { software::choice_of(text); }); };
  for (const software::MethodRow* const row : software::methods())
    CHECK(contains(message("stat"), std::string(row->name)));
  CHECK(contains(message("stat"), "there is no method 'stat'; did you mean status?"));
  for (const software::CoherenceRow& row : software::coherences())
    CHECK(contains(message("status/one"), std::string(row.name)));
  CHECK(contains(message("status/one"), "there is no coherence 'one'"));
  CHECK(contains(message(""), "there is no method ''"));
  CHECK(contains(message("status/"), "there is no coherence ''"));
  CHECK(contains(message("status/one-list/"), "there is no coherence 'one-list/'"));
  CHECK(contains(message("weave/one-list"), "method weave processes whole rays and takes no coherence"));
}