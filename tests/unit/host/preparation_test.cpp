#include "host/emit/compile.h"
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
isa::Preparation of_segments(const isa::Program& program) {
  isa::Preparation sum;
  for (const isa::Segment& segment : program.segments) sum += *segment.preparation;
  return sum;
}

const std::string cube = "cube(size = [10, 10, 10], center = true);";
const std::string moved = "multmatrix([[1, 0, 0, 5], [0, 1, 0, 5], [0, 0, 1, 5], [0, 0, 0, 1]])";

}  // namespace

TEST_CASE("a cube takes the host the transformation of six planes and eight corners") {
  const isa::Program program = compiled(cube);
  CHECK(program.preparation->planes == 6);
  CHECK(program.preparation->points == 8);
  CHECK(program.preparation->nodes == 1);
}

TEST_CASE("a lone cube takes the host box and half-space tests against its rectangle") {
  const isa::Preparation took = of_segments(compiled(cube));
  // Whether it is in the picture, and its block.
  CHECK(took.boxes == 2);
  // Six to narrow the block, and three each for the deciding front and back half-spaces.
  CHECK(took.halfspaces == 12);
  // Three front and three back half-spaces have values at four corners each; then each is compared with the leading
  // ones.
  CHECK(took.values >= 2 * 3 * 4);
  CHECK(took.values <= 2 * (3 + 3 * 3) * 4);
  CHECK(took.supports == 0);
  CHECK(took.nodes == 0);
  CHECK(took.colours == 3);
}

TEST_CASE("each surface of a notched cube takes a test of the other cube by the host") {
  const isa::Preparation took = of_segments(compiled("difference() {" + cube + moved + "{" + cube + "} }"));
  CHECK(took.nodes > 0);
  // Gilbert's algorithm examines eight corners of both in each step.
  CHECK(took.supports > 0);
  CHECK(took.supports % 16 == 0);
  CHECK(took.halfspaces > 24);
}

TEST_CASE("the host's preparation does not count disabled prunings") {
  const std::string notched = "difference() {" + cube + moved + "{" + cube + "} }";
  csg::Pruning pruning;
  pruning.separation = false;
  CHECK(of_segments(compiled(notched, pruning)).supports == 0);
  pruning.halfspaces = false;
  CHECK(of_segments(compiled(notched, pruning)).values == 0);
  const isa::Preparation none = of_segments(compiled(notched, csg::Pruning::none()));
  CHECK(none.supports == 0);
  CHECK(none.values == 0);
  CHECK(none.boxes < of_segments(compiled(notched)).boxes);
}

TEST_CASE("twice as many cubes side by side take twice the host's work") {
  const auto row_of = [](int cubes) {
    std::string row = "group() {";
    for (int i = 0; i < cubes; ++i)
      row += "multmatrix([[1, 0, 0, " + std::to_string(i - 8) +
             "], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]])"
             "{ cube(size = [0.5, 0.5, 0.5], center = true); }";
    return of_segments(compiled(row + "}"));
  };
  const isa::Preparation eight = row_of(8);
  const isa::Preparation sixteen = row_of(16);
  CHECK(sixteen.halfspaces == 2 * eight.halfspaces);
  CHECK(sixteen.values == 2 * eight.values);
  CHECK(sixteen.colours == 2 * eight.colours);
}
