#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "hw/isa/program.h"
#include "sim/functional/clocks.h"
#include "tests/support/drawing.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace isa;

namespace {

testing::Setup setup(emit::Strategy strategy) {
  testing::Setup made;
  made.camera = {{60, -70, 90}, {0, 0, 0}, view::Projection::orthographic};
  made.sampling.width = 64;
  made.sampling.height = 48;
  made.memory_bits = 120;
  made.options.strategy = strategy;
  made.options.stack_bits = 3;
  return made;
}

/// A plate minus `count` separate intersections of a sphere and a peg.
std::string dimpled_plate(int count) {
  const auto at = [](double x, std::string_view solid) {
    return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0,0],[0,0,1,5],[0,0,0,1]]){" + std::string(solid) + "}";
  };
  std::string text = "difference(){cube(size=[60,60,10],center=true);";
  for (int i = 0; i < count; ++i) {
    const double x = 12 * i - 24;
    text += "intersection(){" + at(x, "sphere($fn=8,r=3);") + at(x, "cube(size=4,center=true);") + "}";
  }
  return text + "}";
}

std::vector<Instruction> of_purpose(const isa::Program& program, isa::Purpose purpose) {
  std::vector<Instruction> found;
  for (const Instruction& one : program.segments.at(0).instructions)
    if (one.origin.purpose == purpose && one.opcode != Opcode::skip_if_none) found.push_back(one);
  return found;
}

/// Comparisons of Z1 with Z2 for the surface of the primitive.
std::ptrdiff_t depth_tests(const isa::Program& program, std::uint32_t primitive) {
  const isa::Field z1 = isa::find_field(program, isa::FieldRole::candidate_depth);
  const isa::Field z2 = isa::find_field(program, isa::FieldRole::depth);
  return std::ranges::count_if(program.segments.at(0).instructions, [&](const Instruction& one) {
    return one.opcode == Opcode::field_lt && one.fields[0] == z1 && one.fields[1] == z2 &&
           one.origin.primitive == primitive;
  });
}

}  // namespace

TEST_CASE("with three stack bits a primitive is rendered once and depth-tested per product") {
  for (const int count : {1, 2, 3, 4}) {
    CAPTURE(count);
    testing::Setup how = setup(emit::Strategy::bits);
    how.options.pruning.sets = false;
    const isa::Program three = testing::compile_text(dimpled_plate(count), how).program;
    how.options.strategy = emit::Strategy::stack;
    const isa::Program stack = testing::compile_text(dimpled_plate(count), how).program;
    how.options.strategy = emit::Strategy::products;
    const isa::Program products = testing::compile_text(dimpled_plate(count), how).program;
    // The plate has one product per choice of sphere or peg in each dimple; a sphere lies within plate and peg, a peg
    // within plate and sphere.
    const std::ptrdiff_t of_plate = std::ptrdiff_t{1} << count;
    CHECK(depth_tests(three, 0) == of_plate);
    for (std::uint32_t i = 1; i <= 2 * static_cast<std::uint32_t>(count); ++i) CHECK(depth_tests(three, i) == 1);
    CHECK(three.facts->compile.depth_tests == static_cast<std::uint64_t>(of_plate + 2 * count));
    CHECK(three.facts->compile.rendered == static_cast<std::uint64_t>(1 + 2 * count));
    CHECK(of_purpose(three, isa::Purpose::render) == of_purpose(stack, isa::Purpose::render));
    CHECK(depth_tests(stack, 0) == 1);
    CHECK(products.facts->compile.rendered == three.facts->compile.depth_tests);
    CHECK(three.facts->compile.stack_bits == 1);
  }
}

TEST_CASE("three stack bits render the thesis's objects as often as the strategy stack") {
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    CAPTURE(one.name);
    testing::Setup how = setup(emit::Strategy::bits);
    how.camera = one.camera;
    const isa::Program three = testing::compile_file(testing::model_path(one.name), how).program;
    how.options.strategy = emit::Strategy::stack;
    const isa::Program stack = testing::compile_file(testing::model_path(one.name), how).program;
    how.options.strategy = emit::Strategy::products;
    const isa::Program products = testing::compile_file(testing::model_path(one.name), how).program;
    CHECK(three.facts->compile.rendered == stack.facts->compile.rendered);
    CHECK(three.facts->compile.depth_tests >= stack.facts->compile.depth_tests);
    CHECK(of_purpose(three, isa::Purpose::render) == of_purpose(stack, isa::Purpose::render));
    const machines::Machine machine = testing::machine_of(three.shape);
    CHECK(functional::measure_clocks(three, machine) <= functional::measure_clocks(products, machine));
  }
}

TEST_CASE("a surface hidden before its first product skips all its products in one jump") {
  const std::string hidden =
      "multmatrix([[1,0,0,0],[0,1,0,0],[0,0,1,40],[0,0,0,1]]){cube(size=[99,99,2],center=true);}";
  testing::Setup how = setup(emit::Strategy::bits);
  how.camera = {{0, 0, 90}, {0, 0, 0}, view::Projection::orthographic};
  how.options.pruning.hidden = false;
  how.options.pruning.sets = false;
  const isa::Program program = testing::compile_text(hidden + dimpled_plate(4), how).program;
  const std::vector<Instruction>& all = program.segments.at(0).instructions;
  const auto is_plates = [](const Instruction& one) { return one.origin.primitive == 1; };
  const auto query = std::ranges::find_if(
      all, [&](const Instruction& one) { return one.opcode == Opcode::skip_if_none && is_plates(one); });
  REQUIRE(query != all.end());
  // The remaining instructions of the plate, including colours.
  const auto end = query + 1 + static_cast<std::ptrdiff_t>(query->constant);
  CHECK(std::all_of(query, end, is_plates));
  CHECK(std::none_of(end, all.end(), is_plates));
  CHECK(depth_tests(program, 1) == 16);
  const auto tests_before = std::count_if(
      all.begin(), query, [&](const Instruction& one) { return one.opcode == Opcode::field_lt && is_plates(one); });
  CHECK(tests_before == 1);
}
