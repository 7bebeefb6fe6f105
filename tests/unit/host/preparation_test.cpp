#include "host/emit/compile.h"
#include "hw/isa/facts.h"
#include "hw/isa/host_counts.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

testing::Setup setup_of(const csg::Pruning& pruning) {
  testing::Setup setup;
  setup.camera = testing::camera({30, -40, 20}, {0, 0, 0}, view::Projection::orthographic);
  setup.sampling.width = 256;
  setup.sampling.height = 256;
  setup.options.pruning = pruning;
  return setup;
}

isa::Program compiled(const std::string& csg, const csg::Pruning& pruning = {}) {
  return testing::compile_text(csg, setup_of(pruning)).program;
}

/// Sum over all segments.
isa::Preparation sum_of_segments(const isa::Program& program) {
  isa::Preparation sum;
  for (const isa::Segment& segment : program.segments) sum += *segment.preparation;
  return sum;
}

const std::string cube = "cube(size = [10, 10, 10], center = true);";
const std::string moved = "multmatrix([[1, 0, 0, 5], [0, 1, 0, 5], [0, 0, 1, 5], [0, 0, 0, 1]])";

}  // namespace

TEST_CASE("the host transforms six planes and eight corners for a cube") {
  const isa::Program program = compiled(cube);
  CHECK(program.preparation->planes == 6);
  CHECK(program.preparation->points == 8);
  CHECK(program.preparation->nodes == 0);
  // Per axis, two coordinates times three numbers of the matrix, and normals' components 0 and 1 times four.
  CHECK(program.preparation->products == 2 * 3 * 3 + 2 * 3 * 4);
  // One for each direction in a parallel projection.
  CHECK(program.preparation->quotients == 3);
  // The tree's only node; a plane for each half-space, three components and a direction for each plane, and three
  // coordinates for each corner.
  CHECK(*program.model_preparation == isa::Preparation{.nodes = 1 + 6 + 6 * 4 + 8 * 3});
}

TEST_CASE("cubes side by side share the products and quotients of equal coordinates") {
  const isa::Preparation took = *compiled("group() {" + cube + moved + "{" + cube + "} }").preparation;
  CHECK(took.planes == 12);
  CHECK(took.points == 16);
  // -5 and 5, and 0 and 10, along each axis.
  CHECK(took.products == 4 * 3 * 3 + 2 * 3 * 4);
  CHECK(took.quotients == 3);
}

TEST_CASE("each plane and each point takes a quotient in perspective") {
  testing::Setup setup = setup_of({});
  setup.camera.projection = view::Projection::perspective;
  const isa::Preparation took = *testing::compile_text(cube, setup).program.preparation;
  CHECK(took.quotients == 6 + 8);
  CHECK(took.products == 2 * 3 * 3 + 2 * 3 * 4);
}

TEST_CASE("the host tests the box and half-spaces of a lone cube against its rectangle") {
  const isa::Preparation took = sum_of_segments(compiled(cube));
  // Whether it is in the picture, its block, and the rectangles of the deciding front and back half-spaces.
  CHECK(took.boxes == 2 + 6);
  // Each half-space is tested once over the rectangle, to narrow the block.
  CHECK(took.halfspaces == 6);
  // Three front and three back half-spaces have values at four corners each; then each is compared with the leading
  // ones.
  CHECK(took.values >= 2 * 3 * 4);
  CHECK(took.values <= 2 * (3 + 3 * 3) * 4);
  CHECK(took.supports == 0);
  CHECK(took.nodes == 0);
  CHECK(took.colours == 3);
}

TEST_CASE("support tests of a notched cube are charged once per model and not per segment") {
  const isa::Program program = compiled("difference() {" + cube + moved + "{" + cube + "} }");
  const isa::Preparation took = sum_of_segments(program);
  CHECK(took.nodes > 0);
  CHECK(took.halfspaces > 12);
  // There is no plane between them whose place in the view could be examined.
  CHECK(took.supports == 0);
  // Gilbert's algorithm examines eight corners of both in each step.
  const std::uint64_t supports = program.model_preparation->supports;
  CHECK(supports > 0);
  CHECK(supports % 16 == 0);
  // Three nodes of the tree, and the tables of twelve half-spaces and sixteen corners.
  CHECK(*program.model_preparation == isa::Preparation{.supports = supports, .nodes = 3 + 12 + 12 * 4 + 16 * 3});
}

TEST_CASE("prunings that cost more than they save are left out unless the host is ideal") {
  const std::string notched = "difference() {" + cube + moved + "{" + cube + "} }";
  testing::Setup setup = setup_of({});
  const auto facts_at = [&](const csg::Prices& prices, std::string_view name) {
    setup.options.prices = prices;
    const isa::Program program = testing::compile_text(notched, setup).program;
    for (const isa::PruningFacts& facts : program.facts->prunings)
      if (facts.name == name) return facts;
    return isa::PruningFacts{};
  };
  const csg::Prices free{.are_weighed = true, .instruction = 100};
  CHECK(facts_at(free, "separation").tried > 0);
  CHECK(facts_at(free, "separation").left == 0);
  // A search is estimated at 8 steps of 16 corners; a comparison with a cube at 6 + 3 instructions.
  csg::Prices prices = free;
  prices.support = 9 * 100 / 2.0 / (8 * 16);
  CHECK(facts_at(prices, "separation").left == 0);
  prices.support *= 1.001;
  CHECK(facts_at(prices, "separation").tried == 0);
  CHECK(facts_at(prices, "separation").left > 0);
  prices.are_weighed = false;
  CHECK(facts_at(prices, "separation").tried > 0);
  prices = free;
  prices.box = 9 * 100 / 2.0;
  CHECK(facts_at(prices, "space").left == 0);
  prices.box *= 1.001;
  CHECK(facts_at(prices, "space").tried == 0);
}

TEST_CASE("the host's preparation does not count disabled prunings") {
  const std::string notched = "difference() {" + cube + moved + "{" + cube + "} }";
  csg::Pruning pruning;
  pruning.separation = false;
  CHECK(compiled(notched, pruning).model_preparation->supports == 0);
  pruning.halfspaces = false;
  CHECK(sum_of_segments(compiled(notched, pruning)).values == 0);
  const isa::Preparation none = sum_of_segments(compiled(notched, csg::Pruning::none()));
  CHECK(compiled(notched, csg::Pruning::none()).model_preparation->supports == 0);
  CHECK(none.values == 0);
  CHECK(none.boxes < sum_of_segments(compiled(notched)).boxes);
}

TEST_CASE("twice as many cubes side by side take twice the host's work") {
  const auto row_of = [](int cubes) {
    std::string row = "group() {";
    for (int i = 0; i < cubes; ++i)
      row += "multmatrix([[1, 0, 0, " + std::to_string(i - 8) +
             "], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
             "{ cube(size = [0.5, 0.5, 0.5], center = true); }";
    return sum_of_segments(compiled(row + "}"));
  };
  const isa::Preparation eight = row_of(8);
  const isa::Preparation sixteen = row_of(16);
  CHECK(sixteen.halfspaces == 2 * eight.halfspaces);
  CHECK(sixteen.values == 2 * eight.values);
  // All have the same three visible directions and one colour.
  CHECK(eight.colours == 3);
  CHECK(sixteen.colours == 3);
}
