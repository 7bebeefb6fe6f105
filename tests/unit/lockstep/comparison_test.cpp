#include "sim/lockstep/comparison.h"

#include "hw/isa/facts.h"
#include "hw/isa/opcodes.h"
#include "tests/support/planes_machine.h"
#include "tests/support/random_program.h"
#include "tests/support/test.h"

using namespace csgsim;
using namespace isa;
using testing::planes;

namespace {

constexpr Field z2{0, 8};
constexpr Field colour{8, 6};

Instruction constant(Field target, std::uint64_t value) {
  return {.opcode = Opcode::set_constant, .fields = {target}, .constant = value};
}

/// Assigns a colour to the pixels from column 3.
isa::Program two_columns() {
  isa::Program program;
  program.shape = {5, 2, 20};
  program.colour = colour;
  program.facts->fields = {{"Z2", z2, isa::FieldRole::depth}, {"colour", colour, isa::FieldRole::colour}};
  program.segments.push_back(
      {.region = {0, 0, 5, 2},
       .instructions = {{.opcode = Opcode::enable_all},
                        constant(z2, 17),
                        {.opcode = Opcode::edge_not_negative, .linear = {.a = 1, .c = -3, .width = 8}},
                        constant(colour, 40),
                        constant({16, 2}, 1)}});
  return program;
}

lockstep::Comparison compare(const isa::Program& a, const isa::Program& b) {
  const machines::Machine a_machine = planes(a.shape);
  const machines::Machine b_machine = planes(b.shape);
  const auto functional = engine::make_functional_engine(a_machine);
  const auto reference = engine::make_reference_engine(b_machine);
  return lockstep::compare({a, a_machine, *functional}, {b, b_machine, *reference});
}

lockstep::SideResult run_alone(const isa::Program& program, engine::Engine& engine) {
  observe::FrameObserver frame(program);
  observe::StatsObserver stats(program);
  engine::Observer* const observers[] = {&frame, &stats};
  engine::RunResult result = engine.run(program, observers);
  return {std::move(result), frame.frame(), stats.stats()};
}

bool is_same_run(const lockstep::SideResult& a, const lockstep::SideResult& b) {
  return a.stats == b.stats && a.result.clocks == b.result.clocks && a.result.skips == b.result.skips &&
         a.result.account == b.result.account && !lockstep::first_difference(a.frame, b.frame);
}

}  // namespace

TEST_CASE("a comparison finds two levels equal at every instruction of random Programs") {
  const isa::ArrayShape shape{9, 5, 40};
  CHECK(rc::check([&] {
    const isa::Program program = *test::arbitrary_program(shape, 40, 2);
    const lockstep::Comparison found = compare(program, program);
    RC_ASSERT_FALSE(found.other_instruction.has_value());
    RC_ASSERT_FALSE(found.divergence.has_value());
    RC_ASSERT_FALSE(found.picture.has_value());
    RC_ASSERT(found.compared + found.a.result.skipped == engine::Numbers(program).count());
  }));
}

TEST_CASE("each side of a comparison has the result of a run alone") {
  const isa::ArrayShape shape{9, 5, 40};
  const machines::Machine machine = planes(shape);
  const auto functional = engine::make_functional_engine(machine);
  const auto reference = engine::make_reference_engine(machine);
  CHECK(rc::check([&] {
    const isa::Program a = *test::arbitrary_program(shape, 40, 2);
    const isa::Program b = *test::arbitrary_program(shape, 40, 2);
    const lockstep::Comparison found = compare(a, b);
    RC_ASSERT(is_same_run(found.a, run_alone(a, *reference)));
    RC_ASSERT(is_same_run(found.b, run_alone(b, *functional)));
  }));
}

TEST_CASE("a comparison finds the first divergent instruction and its first pixel") {
  const isa::Program a = two_columns();
  isa::Program b = a;
  b.segments[0].instructions[2].linear.c = -2;  // also enables column 2
  const lockstep::Comparison found = compare(a, b);
  CHECK(found.other_instruction == 2);
  REQUIRE(found.divergence.has_value());
  CHECK(found.divergence->place == engine::Place{0, 2});
  CHECK(found.divergence->pixel == lockstep::PixelDifference{2, 0, {{"E", 0, 1}}, 2});
  CHECK(found.compared == 2);
  REQUIRE(found.picture.has_value());
  CHECK(found.picture->x == 2);
  CHECK(found.picture->y == 0);
  CHECK(found.picture->pixels == 2);
}

TEST_CASE("a comparison reports a differing field by name or position with both values") {
  const isa::Program a = two_columns();
  isa::Program b = a;
  b.segments[0].instructions[3].constant = 41;
  CHECK(compare(a, b).divergence->pixel == lockstep::PixelDifference{3, 0, {{"colour", 40, 41}}, 4});
  b = a;
  b.segments[0].instructions[4].constant = 2;
  const lockstep::Comparison found = compare(a, b);
  CHECK(found.divergence->pixel == lockstep::PixelDifference{3, 0, {{"[14+:6]", 4, 8}}, 4});
  CHECK_FALSE(found.picture.has_value());
}

TEST_CASE("a comparison of Programs of different length ends at their first difference") {
  const isa::Program a = two_columns();
  isa::Program b = a;
  b.segments[0].instructions.insert(b.segments[0].instructions.begin() + 3, {.opcode = Opcode::enable_all});
  const lockstep::Comparison found = compare(a, b);
  CHECK(found.other_instruction == 3);
  CHECK_FALSE(found.divergence.has_value());
  CHECK(found.compared == 3);
  REQUIRE(found.picture.has_value());
  CHECK(found.picture->x == 0);
  CHECK(found.picture->pixels == 6);
  b = a;
  b.segments[0].instructions.pop_back();
  CHECK(compare(a, b).other_instruction == 4);
  CHECK_FALSE(compare(a, b).picture.has_value());
}

TEST_CASE("a comparison detects different clocks of an instruction on equal machines") {
  isa::Program program = two_columns();
  const machines::Machine machine = planes(program.shape);
  machines::Machine wide = machine;
  wide.alu_bits = 4;
  const auto functional = engine::make_functional_engine(machine);
  const auto run = engine::make_functional_engine(wide)->begin(program);
  lockstep::Lockstep lockstep(program, program, *run, {});
  engine::Observer* const observers[] = {&lockstep};
  functional->run(program, observers);
  REQUIRE(lockstep.divergence().has_value());
  CHECK(lockstep.divergence()->place == engine::Place{0, 1});
  CHECK(lockstep.divergence()->otherwise == lockstep::TwoValues{"clocks", 8, 2});
}
