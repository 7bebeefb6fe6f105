// Tests of the designs that csgsim explore requests: options at their limits and the order of samples.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hw/base/error.h"
#include "sim/session/options/usage.h"
#include "sim/studies/design/axes.h"
#include "sim/studies/design/grid.h"
#include "sim/studies/explore/options.h"
#include "tests/support/error_of.h"

using namespace csgsim;
using studies::Dimension;
using Cell = std::vector<std::size_t>;

namespace {

using Texts = std::vector<std::string>;

std::vector<Cell> sampled(const std::vector<std::size_t>& sizes, std::uint64_t seed, std::size_t count) {
  studies::GridSequence sequence(sizes, seed);
  std::vector<Cell> cells;
  while (cells.size() < count) cells.push_back(sequence.next().value());
  return cells;
}

/// Returns the UsageError message for designs; empty if there is none.
std::string design_error(const session::ModelRequest& base, const std::vector<Dimension>& dimensions,
                         const studies::GridChoice& choice = {}) {
  try {
    static_cast<void>(studies::DesignGrid(base, dimensions, choice));
  } catch (const session::UsageError& error) {
    return error.what();
  }
  return "";
}

std::string dimension_error(const std::string& text) {
  return testing::error_of([&] { static_cast<void>(studies::parse_dimension(text)); });
}

/// Consecutive numbers as texts.
Texts numbers_from(unsigned first, std::size_t count) {
  Texts texts;
  for (std::size_t i = 0; i < count; ++i) texts.push_back(std::to_string(first + i));
  return texts;
}

std::string option_error(const std::string& key, const std::string& value) {
  session::ModelRequest options;
  try {
    studies::set_option(options, key, value);
  } catch (const session::UsageError& error) {
    return error.what();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Nine dimensions of a hundred values.
std::vector<Dimension> nine_dimensions() {
  std::vector<Dimension> dimensions{
      {"size", Texts(100, "8x8")}, {"pruning", Texts(100, "all")}, {"curves", Texts(100, "auto")}};
  for (const char* const key : {"z-bits", "fraction-bits", "colour-bits", "stack-bits", "memory-bits"})
    dimensions.push_back({key, Texts(100, "20")});
  dimensions.push_back({"colouring", Texts(100, "field")});
  return dimensions;
}

}  // namespace

// The expected cells come from an independent script with 60 digits: steps are the powers of 1 / 1.618034 (the root of
// x^2 = x + 1), 1 / 1.324718 (x^3 = x + 1) and 1 / 1.220744 (x^4 = x + 1) in 32 bits; the sequence starts at SplitMix64
// (SplitMix64 (seed) + axis); the first number of its seed 0 is the published e220a8397b1dcdaf.
TEST_CASE("a sample follows the additive recurrence from the start given by its seed") {
  CHECK(sampled({1000}, 1, 8) == std::vector<Cell>{{986}, {604}, {222}, {840}, {458}, {76}, {694}, {312}});
  CHECK(sampled({1000}, 2, 8) == std::vector<Cell>{{10}, {628}, {246}, {864}, {482}, {100}, {718}, {336}});
  CHECK(sampled({7, 11}, 1, 8) == std::vector<Cell>{{0, 1}, {6, 7}, {4, 2}, {2, 8}, {0, 4}, {6, 10}, {4, 5}, {2, 0}});
  CHECK(sampled({7, 11}, 5, 8) == std::vector<Cell>{{5, 4}, {3, 0}, {1, 6}, {6, 1}, {5, 8}, {3, 3}, {1, 9}, {0, 4}});
  CHECK(sampled({3, 4, 5}, 1, 8) ==
        std::vector<Cell>{{0, 0, 1}, {0, 3, 4}, {2, 2, 1}, {1, 0, 4}, {1, 3, 2}, {0, 2, 0}, {0, 0, 2}, {2, 3, 0}});
}

TEST_CASE("after 64 repeated cells in a row a sample continues in grid order") {
  // Results of the same script: the 177th cell is the 64th tried after its predecessor; 64 tries find a new one three
  // more times, and then none.
  const std::vector<Cell> cells = sampled({10, 10, 2}, 8, 200);
  const std::vector<Cell> found{cells.begin() + 175, cells.begin() + 180};
  CHECK(found == std::vector<Cell>{{2, 0, 0}, {7, 0, 1}, {8, 4, 0}, {9, 7, 0}, {1, 8, 1}});
  CHECK(std::ranges::is_sorted(cells.begin() + 181, cells.end()));
  CHECK(cells[181] == Cell{0, 2, 0});
  CHECK(cells[182] == Cell{0, 5, 1});
  CHECK(cells.back() == Cell{9, 3, 0});
  // Here 64 tries find no new cell and the 65th would; the next cell in grid order is taken instead.
  const std::vector<Cell> others = sampled({8, 8, 4}, 42, 249);
  CHECK(std::vector<Cell>{others.begin() + 246, others.end()} == std::vector<Cell>{{6, 0, 0}, {0, 5, 0}, {0, 5, 3}});
}

TEST_CASE("a range of --vary includes both ends and has at most 1000 values") {
  CHECK(studies::parse_dimension("a=0..2").values == Texts{"0", "1", "2"});
  CHECK(studies::parse_dimension("a=5..5").values == Texts{"5"});
  CHECK(studies::parse_dimension("a=2000000000..2000000000").values == Texts{"2000000000"});
  CHECK_FALSE(dimension_error("a=2000000000..2000000001").empty());
  CHECK_FALSE(dimension_error("a=2000000001..2000000001").empty());
  CHECK(dimension_error("a=10..8") == "range '10..8' is reversed; use 8..10");
  CHECK(studies::parse_dimension("a=1..1000").values == numbers_from(1, 1000));
  CHECK(dimension_error("a=1..1001") == "range '1..1001' has more than 1000 values; use a shorter range");
  CHECK(studies::parse_dimension("a=1..600,601..1000").values.size() == 1000);
  CHECK(studies::parse_dimension("a=1..600,500..1000").values.size() == 1000);
  CHECK(dimension_error("a=1..600,601..1001") == "a has more than 1000 values; list fewer");
  // Text that is not a range of whole numbers is one value, unchanged.
  CHECK(studies::parse_dimension("a=..5,1.5,a..b,7..x").values == Texts{"..5", "1.5", "a..b", "7..x"});
  CHECK(dimension_error("a=1...3") != "");
  CHECK(dimension_error("a=1..") != "");
}

TEST_CASE("--vary needs a key before the first equals sign") {
  const std::string words = " has no values; use KEY=a,b,c, as in alu.bits=1,2,4";
  for (const char* const text : {"", "alu.bits", "=1", "=a=1"})
    CHECK(dimension_error(text) == "'" + std::string(text) + "'" + words);
  for (const char* const text : {"alu.bits=", "alu.bits=1,,2"}) CHECK(dimension_error(text) != "");
  CHECK(studies::parse_dimension("a=b=c,d") == Dimension{"a", {"b=c", "d"}});
  CHECK(studies::parse_dimension("z-bits=8..10,9,16") == Dimension{"z-bits", {"8", "9", "10", "16"}});
}

TEST_CASE("--vary accepts the values of each option of render up to its limits") {
  struct Row {
    const char* key;
    Texts right;
    Texts wrong;
  };
  const std::vector<Row> rows{{"memory-bits", {"1", "4096"}, {"0", "4097", "x", "1,2", ""}},
                              {"z-bits", {"4", "30"}, {"3", "31"}},
                              {"fraction-bits", {"0", "20"}, {"21", "-1"}},
                              {"colour-bits", {"3", "24"}, {"2", "25"}},
                              {"strategy", {"stack", "list", "bits", "products"}, {"auto", "stac"}},
                              {"stack-bits", {"3", "64"}, {"2", "65"}},
                              {"colouring", {"rebroadcast", "field"}, {"auto", "fields"}},
                              {"curves", {"auto", "facets"}, {"round"}},
                              {"pruning", {"all", "none", "space+hidden"}, {"some"}}};
  for (const Row& row : rows) {
    CAPTURE(row.key);
    for (const std::string& value : row.right) CHECK(option_error(row.key, value) == "");
    for (const std::string& value : row.wrong) CHECK(option_error(row.key, value) != "");
  }
  CHECK(option_error("memory-bits", "1,2") == "'1,2' is not a single number; give one value");
}

TEST_CASE("--vary assigns values to options of render or else to machine parameters") {
  session::ModelRequest options;
  const std::vector<std::pair<std::string, std::string>> values{
      {"size", "9x7"},       {"memory-bits", "70"}, {"z-bits", "11"},    {"fraction-bits", "5"},
      {"colour-bits", "12"}, {"strategy", "bits"},  {"stack-bits", "6"}, {"colouring", "field"},
      {"curves", "facets"},  {"pruning", "none"},   {"alu.bits", "4"}};
  for (const auto& [key, value] : values) studies::set_option(options, key, value);
  CHECK(options.size == "9x7");
  CHECK(options.memory_bits == 70);
  CHECK(options.z_bits == 11);
  CHECK(options.fraction_bits == 5);
  CHECK(options.colour_bits == 12);
  CHECK(options.strategy == "bits");
  CHECK(options.stack_bits == 6);
  CHECK(options.colouring == "field");
  CHECK(options.curves == "facets");
  CHECK(options.pruning == "none");
  CHECK(options.machine == "pixel-planes-4+alu.bits=4");
  CHECK(studies::axis_keys() == Texts{"size", "memory-bits", "z-bits", "fraction-bits", "colour-bits", "strategy",
                                      "stack-bits", "colouring", "curves", "pruning"});
}

TEST_CASE("exactly four parameters of machines set the memory of a pixel") {
  for (const char* const key : {"array.memory_bits", "pixel.memory_bits", "cells.words", "cells.word_bits"})
    CHECK(studies::is_memory_figure(key));
  for (const char* const key : {"", "memory_bits", "memory.reads", "node.memory_words", "memory-bits"})
    CHECK_FALSE(studies::is_memory_figure(key));
}

TEST_CASE("explore requests all designs by default or the sample of seed 1") {
  const std::vector<Dimension> dimensions{{"z-bits", numbers_from(4, 27)}};
  CHECK(studies::GridChoice{}.points == 0);
  CHECK(studies::GridChoice{}.seed == 1);
  CHECK(studies::ExploreOptions{}.points == 0);
  CHECK(studies::ExploreOptions{}.seed == 1);
  CHECK(studies::ExploreOptions{}.search == 0);
  CHECK(studies::DesignGrid({}, dimensions, {}).designs().size() == 27);
  studies::GridChoice ten;
  ten.points = 10;
  Texts drawn;
  for (const Cell& cell : sampled({27}, 1, 10)) drawn.push_back(std::to_string(4 + cell[0]));
  Texts listed;
  const studies::DesignGrid grid({}, dimensions, ten);
  for (const session::ModelRequest& one : grid.designs()) listed.push_back(std::to_string(one.z_bits));
  CHECK(listed == drawn);
}

TEST_CASE("a grid of designs may have 10000 cells and a larger one must be sampled") {
  CHECK(studies::max_designs == 10'000);
  const Texts tens(10, "20");
  std::vector<Dimension> dimensions{
      {"z-bits", tens}, {"fraction-bits", tens}, {"colour-bits", tens}, {"stack-bits", tens}};
  CHECK(studies::DesignGrid({}, dimensions, {}).designs().size() == 1);  // all draw the same picture
  dimensions[3].values.emplace_back("21");
  CHECK(design_error({}, dimensions) ==
        "--vary: the grid has 11000 designs, the maximum is 10,000; use --points N to sample them");
  CHECK(design_error({}, dimensions, {1, 1}) == "");
}

TEST_CASE("a grid of 10^18 designs may be sampled") { CHECK(design_error({}, nine_dimensions(), {1, 1}) == ""); }

TEST_CASE("a sample of a grid of more than 10^18 designs is rejected") {
  std::vector<Dimension> dimensions = nine_dimensions();
  dimensions[8].values.emplace_back("field");
  CHECK(design_error({}, dimensions, {1, 1}) == "--vary: the grid has more than 10^18 designs; vary fewer parameters");
}

TEST_CASE("--vary rejects an unknown key and lists options and the nearest parameter") {
  const std::string options =
      "size, memory-bits, z-bits, fraction-bits, colour-bits, strategy, stack-bits, colouring, curves, pruning";
  CHECK(design_error({}, {{"array.widt", {"1"}}}) ==
        "--vary: 'array.widt' is neither a parameter of pixel-planes-4 nor one of " + options +
            "; did you mean 'array.width'?");
  CHECK(design_error({}, {{"curve", {"auto"}}}).find("did you mean 'curves'?") != std::string::npos);
  CHECK(design_error({}, {{"alu.bits", {"1"}}, {"alu.bits", {"2"}}}) ==
        "--vary: 'alu.bits' is given twice; list all its values once");
}

TEST_CASE("--vary rejects a value impossible both alone and with other keys' last values") {
  // The trees of pixel-planes-4 deliver one bit per clock, and its ALU takes one: neither may be 4 without the other.
  const Dimension alu{"alu.bits", {"1", "4"}};
  const Dimension trees{"evaluator.bits", {"1", "4"}};
  CHECK(design_error({}, {trees, alu}) == "");
  CHECK(design_error({}, {alu, trees}) == "");
  CHECK(design_error({}, {trees}).starts_with("--vary evaluator.bits: "));
  CHECK(design_error({}, {trees, {"alu.bits", {"4", "1"}}}).starts_with("--vary evaluator.bits: "));
  CHECK(design_error({}, {{"alu.bits", {"0"}}}).starts_with("--vary alu.bits: "));
  CHECK(design_error({}, {{"z-bits", {"3"}}}).starts_with("--vary z-bits: "));
  CHECK(design_error({}, {{"strategy", {"auto"}}}).starts_with("--vary strategy: "));
  CHECK(design_error({}, {{"strategy", {"stak"}}}).find("did you mean stack") != std::string::npos);
  CHECK(design_error({}, {{"size", {"8x8", "0x8"}}}).starts_with("--vary size: "));
  CHECK(design_error({}, {{"pruning", {"al"}}}).starts_with("--vary pruning: "));
}

TEST_CASE("--vary rejects a parameter that conflicts with an option, accepts an equal one") {
  const auto error = [](const char* key, const char* value) {
    return std::string("--vary: an option overrides ") + key + "=" + value + "; omit --size or --memory-bits";
  };
  session::ModelRequest sized;
  sized.size = "64x48";
  CHECK(design_error(sized, {{"array.width", {"64"}}}) == "");
  CHECK(design_error(sized, {{"array.width", {"64", "65"}}}) == error("array.width", "65"));
  CHECK(design_error(sized, {{"array.height", {"47"}}}) == error("array.height", "47"));
  session::ModelRequest remembered;
  remembered.memory_bits = 80;
  CHECK(design_error(remembered, {{"array.memory_bits", {"80"}}}) == "");
  CHECK(design_error(remembered, {{"array.memory_bits", {"80", "81"}}}) == error("array.memory_bits", "81"));
  // A varied key is also an option: its first value is used.
  CHECK(design_error({}, {{"array.memory_bits", {"90"}}, {"memory-bits", {"90", "91"}}}) == "");
  CHECK(design_error({}, {{"array.memory_bits", {"91"}}, {"memory-bits", {"90", "91"}}}) ==
        error("array.memory_bits", "91"));
}

TEST_CASE("neighbours of a design follow key order with the lower value first") {
  // z bits 10 to 14 times fraction bits 2 to 6: four neighbours of the middle, none of them already known.
  const std::vector<Dimension> dimensions{{"z-bits", numbers_from(10, 5)}, {"fraction-bits", numbers_from(2, 5)}};
  const auto listed = [](const studies::DesignGrid& grid) {
    std::vector<std::pair<unsigned, unsigned>> all;
    for (const session::ModelRequest& one : grid.designs()) all.emplace_back(one.z_bits, one.fraction_bits);
    return all;
  };
  using Pairs = std::vector<std::pair<unsigned, unsigned>>;
  std::size_t corners = 0;
  for (std::uint32_t seed = 1; seed <= 30; ++seed) {
    studies::DesignGrid grid({}, dimensions, {1, seed});
    const auto [z, fraction] = listed(grid).front();
    Pairs expected{{z, fraction}};
    if (z > 10) expected.emplace_back(z - 1, fraction);
    if (z < 14) expected.emplace_back(z + 1, fraction);
    if (fraction > 2) expected.emplace_back(z, fraction - 1);
    if (fraction < 6) expected.emplace_back(z, fraction + 1);
    corners += expected.size() == 3 ? 1U : 0U;
    const std::array<std::size_t, 1> first{0};
    grid.add_neighbours(first, 0);
    CHECK(listed(grid).size() == 1);
    grid.add_neighbours(first, 2);
    CHECK(listed(grid) == Pairs{expected[0], expected[1], expected[2]});
    grid.add_neighbours(first, 100);
    CHECK(listed(grid) == expected);
    grid.add_neighbours(first, 100);
    CHECK(listed(grid) == expected);
    // The first design, a neighbour of the second, is already known.
    const std::size_t before = expected.size();
    const std::array<std::size_t, 1> second{1};
    grid.add_neighbours(second, 1);
    CHECK(grid.designs().size() == before + 1);
  }
  CHECK(corners > 0);
}