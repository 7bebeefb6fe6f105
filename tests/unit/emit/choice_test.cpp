#include <doctest/doctest.h>

#include <string>

#include "hw/base/error.h"
#include "hw/isa/facts.h"
#include "hw/machines/clocks.h"
#include "hw/pixel_planes/kind.h"
#include "hw/scan_line/kind.h"
#include "tests/support/drawing.h"

using namespace csgsim;

namespace {

testing::Setup setup(emit::Strategy strategy, unsigned stack_bits = emit::min_stack_bits) {
  testing::Setup made;
  made.camera = {{60, -70, 90}, {0, 0, 0}, view::Projection::orthographic};
  made.sampling.width = 64;
  made.sampling.height = 48;
  made.memory_bits = 120;
  made.options.strategy = strategy;
  made.options.stack_bits = stack_bits;
  return made;
}

std::string at(double x, double y, double z, const std::string& solid) {
  return "multmatrix([[1,0,0," + std::to_string(x) + "],[0,1,0," + std::to_string(y) + "],[0,0,1," + std::to_string(z) +
         "],[0,0,0,1]]){" + solid + "}";
}

/// A plate minus `count` intersections of a sphere and a peg: 2^count products.
std::string dimpled_plate(int count) {
  std::string text = "difference(){cube(size=[60,60,10],center=true);";
  for (int i = 0; i < count; ++i) {
    const int column = i % 8;
    const int row = i / 8;
    const double x = 7 * column - 25;
    const double y = 7 * row - 25;
    text += "intersection(){" + at(x, y, 5, "sphere($fn=8,r=3);") + at(x, y, 5, "cube(size=4,center=true);") + "}";
  }
  return text + "}";
}

std::uint64_t clocks_of(const isa::Program& program) {
  machines::Machine machine = machines::blank_machine(pixel_planes::kind);
  machine.array = program.shape;
  std::uint64_t clocks = 0;
  for (const isa::Instruction& instruction : program.segments.at(0).instructions) {
    clocks += machines::clocks(instruction, machine);
  }
  return clocks;
}

isa::Program compiled(const std::string& text, const testing::Setup& how) {
  return testing::compile_text(text, how).program;
}

}  // namespace

TEST_CASE("strategy auto takes no more clocks than any strategy and colouring it tries") {
  for (const char* name : {"carburettor", "old_example002", "thesis_fig_2_3"}) {
    CAPTURE(name);
    testing::Setup how = setup(emit::Strategy::automatic);
    how.options.colouring = emit::Colouring::automatic;
    const isa::Program best = testing::compile_file(testing::model_path(name), how).program;
    CHECK(best.facts->compile.strategy != "auto");
    CHECK(best.facts->compile.colouring != "auto");
    for (const emit::Colouring colouring : {emit::Colouring::field, emit::Colouring::rebroadcast}) {
      for (const emit::Strategy strategy : emit::default_strategies()) {
        // Strategy stored needs more memory, and products is not among the candidates.
        if (strategy == emit::Strategy::stored || strategy == emit::Strategy::products) continue;
        for (const unsigned bits : {3U, 4U, 5U, 6U}) {
          how.options.strategy = strategy;
          how.options.stack_bits = bits;
          how.options.colouring = colouring;
          CHECK(clocks_of(best) <= clocks_of(testing::compile_file(testing::model_path(name), how).program));
        }
      }
    }
  }
}

TEST_CASE("strategy auto takes the strategy with the fewest clocks by a given function") {
  testing::Setup how = setup(emit::Strategy::automatic);
  how.options.colouring = emit::Colouring::automatic;
  const testing::Compiled model = testing::compile_file(testing::model_path("old_example002"), how);
  const machines::Machine machine = testing::machine_of(model.program.shape);
  const auto compile_by = [&](const emit::ClockCounter& count) {
    return emit::compile(model.tree, model.scene, model.view, machine, how.options, count);
  };
  const auto prefer = [](const std::string& strategy) {
    return [=](const isa::Program& program) { return program.facts->compile.strategy == strategy ? 1ULL : 2ULL; };
  };
  CHECK(compile_by(prefer("list")).facts->compile.strategy == "list");
  CHECK(compile_by(prefer("stack")).facts->compile.strategy == "stack");
  CHECK(compile_by({}) == model.program);
}

TEST_CASE("strategy auto chooses an option that fits in memory") {
  testing::Setup how = setup(emit::Strategy::automatic);
  how.options.colouring = emit::Colouring::automatic;
  how.memory_bits = 72;
  CHECK(compiled(dimpled_plate(3), how).facts->compile.colouring == "rebroadcast");
  how.memory_bits = 120;
  CHECK(compiled(dimpled_plate(3), how).facts->compile.colouring == "field");
  how.memory_bits = 64;
  CHECK_THROWS_AS(compiled(dimpled_plate(3), how), InputError);
}

TEST_CASE("strategy auto chooses stored depths if they fit in memory") {
  testing::Setup how = setup(emit::Strategy::automatic);
  how.options.colouring = emit::Colouring::automatic;
  how.memory_bits = 1024;
  const std::string path = testing::model_path("old_example002");
  const isa::Program best = testing::compile_file(path, how).program;
  CHECK(best.facts->compile.strategy == "stored");
  for (const emit::Strategy strategy : emit::strategies) {
    if (strategy == emit::Strategy::automatic) continue;
    for (const emit::Colouring colouring : {emit::Colouring::field, emit::Colouring::rebroadcast}) {
      CAPTURE(emit::name_of(strategy));
      how.options.strategy = strategy;
      how.options.colouring = colouring;
      CHECK(clocks_of(best) <= clocks_of(testing::compile_file(path, how).program));
    }
  }
}

TEST_CASE("fifty subtracted intersections compile with every strategy without products") {
  for (const emit::Strategy strategy : {emit::Strategy::stack, emit::Strategy::list, emit::Strategy::automatic}) {
    CHECK(compiled(dimpled_plate(50), setup(strategy)).facts->compile.rendered > 50);
  }
  CHECK(compiled(dimpled_plate(50), setup(emit::Strategy::bits, 5)).facts->compile.rendered > 50);
}

TEST_CASE("too many products are an error with the primitive's location and an alternative") {
  std::vector<testing::Setup> setups{setup(emit::Strategy::products)};
  for (const unsigned bits : {3U, 4U}) {
    CHECK(compiled(dimpled_plate(50), setup(emit::Strategy::bits, bits)).facts->compile.rendered > 50);
    setups.push_back(setup(emit::Strategy::bits, bits));
    setups.back().options.pruning.sets = false;
  }
  for (const testing::Setup& how : setups) {
    CHECK_NOTHROW(compiled(dimpled_plate(8), how));
    try {
      compiled(dimpled_plate(50), how);
      FAIL("compiled 2^50 products instead of rejecting them");
    } catch (const InputError& error) {
      const std::string text = error.what();
      CHECK(text.find("test:1:14: ") == 0);
      CHECK(text.find("more than 16384 products") != std::string::npos);
      CHECK(text.find("--strategy stack") != std::string::npos);
    }
  }
}

TEST_CASE("surfaces with a single product do not count towards the limit on products") {
  std::string text = "intersection(){cube(size=900,center=true);union(){";
  for (int i = 0; i < 80; ++i) text += at(4 * i - 160, 0, 0, "cube(size=[1,1,500],center=true);");
  testing::Setup how = setup(emit::Strategy::stack);
  how.kind = &scan_line::kind;
  how.camera = {{0, -1000, 0}, {0, 0, 0}, view::Projection::orthographic};
  how.sampling.width = 512;
  how.sampling.height = 512;
  for (const unsigned bits : {3U, 4U}) {
    CHECK(compiled(text + "}}", how).facts->compile.rendered > emit::max_products);
    how.options.strategy = emit::Strategy::bits;
    how.options.stack_bits = bits;
  }
}

TEST_CASE("more stack bits never increase the work of strategy bits") {
  for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
    for (const testing::ThesisObject& one : testing::thesis_objects(projection)) {
      CAPTURE(one.name);
      testing::Setup how = setup(emit::Strategy::stack);
      how.camera = one.camera;
      const isa::CompileFacts once = testing::compile_file(testing::model_path(one.name), how).program.facts->compile;
      isa::CompileFacts before;
      for (unsigned bits = 3; bits <= once.tree_depth + 3; ++bits) {
        how.options = setup(emit::Strategy::bits, bits).options;
        const isa::CompileFacts facts =
            testing::compile_file(testing::model_path(one.name), how).program.facts->compile;
        CHECK(facts.rendered == once.rendered);
        if (bits > 3) {
          CHECK(facts.depth_tests <= before.depth_tests);
          CHECK(facts.classified <= before.classified);
          CHECK(facts.depth_tests == once.depth_tests);
        }
        before = facts;
      }
      CHECK(before.classified == once.classified);
    }
  }
}