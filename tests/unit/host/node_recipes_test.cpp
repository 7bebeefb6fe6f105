#include "hw/host/node_recipes.h"

#include "hw/host/recipes.h"
#include "hw/kinds/load.h"
#include "hw/machines/change_error.h"
#include "hw/machines/schema.h"
#include "hw/multi_processor/figures.h"
#include "hw/processors/processor.h"
#include "tests/support/test.h"

using namespace csgsim;
using multi_processor::Figures;

namespace {

Figures figures_of(const std::string& changes) {
  return machines::kind_figures<Figures>(kinds::load("multi-processor" + changes));
}

std::uint64_t clocks_on_mc68000(const processors::Operations& operations) {
  return static_cast<std::uint64_t>(processors::clocks(operations, processors::built_in_processor("mc68000")));
}

}  // namespace

TEST_CASE("host tasks take the same MC68000 clocks on a node and the display processor") {
  const Figures figures = figures_of("");
  for (const multi_processor::TestClocks& tests : {figures.display_tests, figures.node_tests}) {
    CHECK(tests.primitive == clocks_on_mc68000(host::recipe("boxes")));
    CHECK(tests.halfspace == clocks_on_mc68000(host::recipe("tests")));
  }
  CHECK(figures.node_tests.tree_node == clocks_on_mc68000(host::recipe("nodes")) + figures.node_tests.primitive);
}

TEST_CASE("a node in assembly takes the clocks of the MC68000 manual") {
  const Figures figures = figures_of("+node.compiler_factor=1000+display.compiler_factor=1000");
  CHECK(figures.operations ==
        multi_processor::OperationClocks{
            .read = 12, .write = 12, .add = 4, .compare = 4, .logic = 4, .multiply = 70, .shift = 6, .shift_bit = 2});
  CHECK(figures.branches.taken == 10);
  CHECK(figures.branches.passed == 8);
  CHECK(figures.field_clocks == 4 + 4 + 10);
  CHECK(figures.chain.link == 3 * 12 + 8);
  CHECK(figures.chain.call == 18 + 16);
  CHECK(figures.loop ==
        multi_processor::LoopClocks{.pixel = 10, .row = 10 + 2 * 8 + 4, .instruction = 12 + 16 + 10 + 16});
  // Four values: read 16, two sums 8 each, compare 6, branches 8 and 10; three more leaders.
  CHECK(figures.node_tests.cell == 4 * (16 + 16 + 6 + 8 + 10) + 3 * (16 + 6 + 8));
  CHECK(figures.display_tests.cell == figures.node_tests.cell);
  CHECK(figures.number_clocks == 4 * (6 + 8) + 3 * 12);
  CHECK(figures.node_tests.instruction == processors::hand_written_clocks(host::instruction_listing_operations(),
                                                                          processors::built_in_processor("mc68000")));
  // Twelve products, of a number read and one read by the quotient and the plane.
  constexpr std::uint64_t products = 12 * (16 + 344);
  // Nine numbers read, six sums, a division, two products, three shifts by 12, two comparisons and branches, three
  // results stored.
  constexpr std::uint64_t quotient = 9 * 16 + 6 * 8 + 1576 + 2 * 344 + 3 * (8 + 12 * 2) + 2 * (6 + 8) + 3 * 16;
  // Offset, three numbers, reciprocal and places read; three sums, a product, a shift; one result.
  constexpr std::uint64_t plane = 6 * 16 + 3 * 8 + 344 + (8 + 12 * 2) + 2 * (6 + 8) + 16;
  CHECK(figures.transform_clocks == products + quotient + plane);
}

TEST_CASE("another node processor changes only the parameters that are left to it") {
  const Figures figures = figures_of("+node.processor=i486dx2+node.cell_clocks=422");
  CHECK(figures.node_processor.compiler_factor == 1500);
  CHECK(figures.operations.read == 2);  // 1.5, rounded up
  CHECK(figures.operations.multiply == 39);
  CHECK(figures.operations.shift_bit == 0);
  CHECK(figures.node_tests.cell == 422);
  CHECK(figures.display_tests == figures_of("").display_tests);
  CHECK(figures.transform_clocks == figures_of("").transform_clocks);
  CHECK(figures_of("+display.processor=i860").transform_clocks < figures.transform_clocks);
}

TEST_CASE("the value `processor` is accepted only for parameters with a recipe") {
  CHECK_THROWS_WITH_AS(kinds::load("multi-processor+node.word_bits=processor"),
                       doctest::Contains("node.word_bits is 'processor'; write a whole number of bits"),
                       machines::ChangeError);
  CHECK_THROWS_WITH_AS(kinds::load("multi-processor+node.cell_clocks=many"),
                       doctest::Contains("is 'many'; write a whole number of clocks, or \"processor\""),
                       machines::ChangeError);
  CHECK_THROWS_WITH_AS(kinds::load("multi-processor+node.field_clocks=many"),
                       doctest::Contains("is 'many'; write a whole number of clocks, or \"ideal\", or \"processor\""),
                       machines::ChangeError);
  CHECK_THROWS_WITH_AS(kinds::load("multi-processor+node.processor=ideal"),
                       doctest::Contains("node.processor is 'ideal'; it must be one of i486dx2, i860, mc68000"),
                       machines::ChangeError);
}

TEST_CASE("a parameter set to `processor` keeps that value and is used with its clocks") {
  const machines::Machine machine = kinds::load("multi-processor+node.processor=mc68020-weitek");
  CHECK(machine.name == "multi-processor+node.processor=mc68020-weitek");
  const auto found = std::ranges::find(machine.figures, "node.read_clocks", &machines::Figure::key);
  REQUIRE(found != machine.figures.end());
  CHECK(found->value == machines::priced_value);
  CHECK(machines::used_value(*found, machine) == "11");  // 7 times 1.5, rounded up
}
