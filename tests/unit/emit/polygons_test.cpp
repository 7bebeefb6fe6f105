#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "hw/pixel_square/kind.h"
#include "tests/oracle/random_model.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace isa;

namespace {

testing::Setup setup(emit::Strategy strategy) {
  testing::Setup made;
  made.camera = {{60, -70, 90}, {0, 0, 0}, view::Projection::orthographic};
  made.sampling.width = 96;
  made.sampling.height = 80;
  made.memory_bits = 256;
  made.options.strategy = strategy;
  return made;
}

/// Comparison with the depth of a face.
bool compares(const Instruction& one) {
  return one.origin.purpose == isa::Purpose::render &&
         (one.opcode == Opcode::linear_lt || one.opcode == Opcode::linear_le || one.opcode == Opcode::linear_gt);
}

std::size_t count(const isa::Program& program, const auto& is_one) {
  std::size_t counted = 0;
  for (const isa::Segment& segment : program.segments)
    counted += static_cast<std::size_t>(std::ranges::count_if(segment.instructions, is_one));
  return counted;
}

std::size_t faces_loaded(const isa::Program& program) {
  return count(program, [](const Instruction& one) {
    return one.origin.purpose == isa::Purpose::render && one.opcode == Opcode::load_linear;
  });
}

}  // namespace

TEST_CASE("a cube's face is compared with its neighbours and the first wins ties") {
  const isa::Program program =
      testing::compile_text("cube(size=20,center=true);", setup(emit::Strategy::polygons)).program;
  CHECK(faces_loaded(program) == 3);
  // Each face has four neighbours, except at the two vertical outline edges, where the cube's bounding rectangle ends.
  CHECK(count(program, compares) == 12 - 2);
  // Each of the three edges between front faces is owned by one of the two faces.
  CHECK(count(program, [](const Instruction& one) { return one.opcode == Opcode::linear_le; }) == 3);
  CHECK(count(program, [](const Instruction& one) { return one.opcode == Opcode::linear_lt && compares(one); }) == 3);
  CHECK(program.facts->compile.strategy == "polygons");
  CHECK(program.facts->compile.depth_tests == 3);
}

TEST_CASE("a face of a cylinder with many sides is compared with only a few other faces") {
  const isa::Program program =
      testing::compile_text("cylinder($fn=120,h=30,r1=25,r2=25,center=true);", setup(emit::Strategy::polygons)).program;
  const std::size_t faces = faces_loaded(program);
  CHECK(faces > 50);
  CHECK(faces < 64);
  // The end face is compared with all sides, and a side with two sides and both ends.
  CHECK(count(program, compares) < 130 + 8 * faces);
}

TEST_CASE("strategies polygons and stack draw the same pictures of random models") {
  std::size_t most_faces = 0;
  for (std::uint64_t seed = 1; seed <= 80; ++seed) {
    CAPTURE(seed);
    std::string model = testing::random_model(seed, 2 + static_cast<unsigned>(seed % 9));
    if (seed % 4 != 0) model = testing::random_model(seed + 1000, 1) + testing::random_model(seed + 2000, 1) + model;
    testing::Setup how = setup(emit::Strategy::stack);
    how.camera = {
        {9, -13.5, 10.5}, {0, 0, 0}, seed % 3 == 0 ? view::Projection::orthographic : view::Projection::perspective};
    how.sampling.z_bits = 8 + static_cast<unsigned>(seed % 3) * 6;
    if (seed % 2 == 0) {
      how.kind = &pixel_square::kind;
      how.square = {16, 16};
    }
    const testing::Compiled stack = testing::compile_text(model, how);
    how.options.strategy = emit::Strategy::polygons;
    const isa::Program polygons = testing::compile_again(stack, how);
    const observe::Frame expected = testing::draw(stack.program);
    const observe::Frame drawn = testing::draw(polygons);
    CHECK(drawn.depth == expected.depth);
    CHECK(drawn.owner == expected.owner);
    CHECK(drawn.colour == expected.colour);
    most_faces = std::max(most_faces, faces_loaded(polygons));
  }
  CHECK(most_faces > 40);
}

TEST_CASE("strategy polygons uses the stack for compared primitives and near cuts") {
  const std::string model = "difference(){cube(size=20,center=true);cylinder($fn=8,h=40,r1=5,r2=5,center=true);}";
  testing::Setup how = setup(emit::Strategy::stack);
  const testing::Compiled stack = testing::compile_text(model, how);
  how.options.strategy = emit::Strategy::polygons;
  CHECK(testing::compile_again(stack, how).segments.at(0).instructions == stack.program.segments.at(0).instructions);
}
