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

constexpr unsigned z_bits = 20;

testing::Setup setup(emit::Strategy strategy) {
  testing::Setup made;
  made.camera = {{60, -70, 90}, {0, 0, 0}, view::Projection::orthographic};
  made.sampling.width = 64;
  made.sampling.height = 48;
  made.sampling.z_bits = z_bits;
  made.memory_bits = 4096;
  made.options.strategy = strategy;
  return made;
}

isa::Program compiled(const std::string& text, testing::Setup how, emit::Strategy strategy) {
  how.options.strategy = strategy;
  return testing::compile_text(text, how).program;
}

std::string cube(double x, double size) {
  return "multmatrix([[1,0,0," + std::to_string(x) +
         "],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(size=" + std::to_string(size) + ",center=true);}";
}

bool stores(const Instruction& one) {
  return one.origin.purpose == isa::Purpose::classify && one.origin.node == isa::no_node &&
         one.opcode != Opcode::skip_if_none;
}

bool compares(const Instruction& one) {
  return one.origin.purpose == isa::Purpose::classify && one.origin.node != isa::no_node;
}

/// Primitives that the surfaces of a segment are compared with.
std::set<std::uint32_t> compared_in(const isa::Segment& segment) {
  std::set<std::uint32_t> all;
  for (const Instruction& one : segment.instructions)
    if (compares(one)) all.insert(one.origin.node);
  return all;
}

/// Primitives whose depths are stored, in the order of their first instruction.
std::vector<std::uint32_t> stored_in(const isa::Segment& segment) {
  std::vector<std::uint32_t> all;
  for (const Instruction& one : segment.instructions)
    if (stores(one) && (all.empty() || all.back() != one.origin.primitive)) all.push_back(one.origin.primitive);
  return all;
}

unsigned stored_fields(const isa::Program& program) {
  return static_cast<unsigned>(
      std::ranges::count(program.facts->fields, isa::FieldRole::stored, &isa::NamedField::role));
}

std::string refusal(const std::string& text, const testing::Setup& how) {
  return testing::error_of([&] { testing::compile_text(text, how); });
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("strategy stored keeps a front and a back depth per compared primitive") {
  // The sphere is compared with the others, two cubes with the sphere, and the separate cube with nothing.
  const std::string model = "difference(){sphere($fn=12,r=9);" + cube(-8, 6) + cube(8, 6) + "}" + cube(40, 5);
  const isa::Program program = compiled(model, setup(emit::Strategy::stored), emit::Strategy::stored);
  CHECK(stored_in(program.segments.at(0)) == std::vector<std::uint32_t>{0, 1, 2});
  CHECK(stored_fields(program) == 6);
  // The mask, and no pending result.
  CHECK(program.facts->compile.stack_bits == 1 + 2 * 3 * z_bits);
  CHECK(program.facts->compile.rendered == 4);
}

TEST_CASE("strategy stored keeps exactly the primitives that a stack would compare") {
  std::size_t overall_max = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    CAPTURE(seed);
    const std::string model = testing::random_model(seed, 3 + static_cast<unsigned>(seed % 10));
    testing::Setup how = setup(emit::Strategy::stored);
    how.camera = {{9, -13.5, 10.5}, {0, 0, 0}, view::Projection::perspective};
    // This pruning is off so that each comparison has instructions.
    how.options.pruning.halfspaces = false;
    if (seed % 2 == 0) {
      how.kind = &pixel_square::kind;
      how.square = {16, 16};
    }
    const isa::Program stored = compiled(model, how, emit::Strategy::stored);
    const isa::Program stack = compiled(model, how, emit::Strategy::stack);
    std::size_t most = 0;
    for (std::size_t i = 0; i < stack.segments.size(); ++i) {
      const std::set<std::uint32_t> compared = compared_in(stack.segments[i]);
      const std::vector<std::uint32_t> kept = stored_in(stored.segments.at(i));
      // A comparison of primitives without common pixels needs no depths.
      CHECK(std::ranges::includes(compared, kept));
      CHECK(compared_in(stored.segments[i]) == compared);
      most = std::max(most, kept.size());
    }
    CHECK(stored_fields(stored) == 2 * most);
    CHECK(stored.facts->compile.stack_bits == stack.facts->compile.stack_bits + 2 * most * z_bits);
    CHECK(stored.facts->compile.classified == stack.facts->compile.classified);
    CHECK(stored.facts->compile.depth_tests == stack.facts->compile.depth_tests);
    overall_max = std::max(overall_max, most);
  }
  CHECK(overall_max >= 5);
}

TEST_CASE("strategy stored broadcasts the half-spaces of compared primitives once") {
  for (const testing::ThesisObject& one : testing::thesis_objects(view::Projection::perspective)) {
    CAPTURE(one.name);
    testing::Setup how = setup(emit::Strategy::stored);
    how.camera = one.camera;
    const isa::Program program = testing::compile_file(testing::model_path(one.name), how).program;
    const isa::Field z1 = isa::find_field(program, isa::FieldRole::candidate_depth);
    std::map<std::pair<std::uint32_t, std::uint32_t>, unsigned> comparisons;
    for (const Instruction& each : program.segments.at(0).instructions) {
      if (!compares(each)) continue;
      const bool is_nowhere = each.opcode == Opcode::edge_negative;
      const bool is_of_fields = (each.opcode == Opcode::field_le && each.fields[1] == z1) ||
                                (each.opcode == Opcode::field_lt && each.fields[0] == z1);
      CHECK((is_nowhere || is_of_fields));
      ++comparisons[{each.origin.primitive, each.origin.node}];
    }
    for (const auto& [pair, count] : comparisons) CHECK(count <= 2);
    // Each primitive is scan-converted once, for its own surface or for those of others.
    how.options.strategy = emit::Strategy::stack;
    CHECK(program.facts->compile.rendered ==
          testing::compile_file(testing::model_path(one.name), how).program.facts->compile.rendered);
  }
}

TEST_CASE("the error for too little memory names the bits that stored depths need") {
  const std::string model = "difference(){sphere($fn=12,r=9);" + cube(-8, 6) + cube(8, 6) + "}";
  testing::Setup how = setup(emit::Strategy::stored);
  how.memory_bits = 72;
  const std::string message = refusal(model, how);
  CHECK(contains(message,
                 "the picture needs 185 memory bits a pixel (2 x 20 depth, 24 colour, 1 mask, 6 x 20 stored depth)"));
  CHECK(contains(message, "--strategy list or auto"));
  CHECK(contains(message, "--z-bits 5,"));
  CHECK(contains(message, "take --memory-bits 185"));
  how.memory_bits = 184;
  CHECK_FALSE(refusal(model, how).empty());
  how.memory_bits = 185;
  CHECK(refusal(model, how).empty());
  how.memory_bits = 72;
  how.sampling.z_bits = 5;
  CHECK(refusal(model, how).empty());
}

TEST_CASE("an error suggests no memory size if no machine can hold the stored depths") {
  std::string model = "difference(){cube(size=[60,60,10],center=true);";
  for (int i = 0; i < 120; ++i) model += cube(0.3 * i - 20, 11 + 0.1 * i);
  const std::string message = refusal(model + "}", setup(emit::Strategy::stored));
  CHECK(contains(message, "memory bits a pixel"));
  CHECK(contains(message, "--strategy list or auto"));
  CHECK_FALSE(contains(message, "take --memory-bits"));
}
