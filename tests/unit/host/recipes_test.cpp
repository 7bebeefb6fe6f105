#include "hw/host/recipes.h"

#include <initializer_list>

#include "hw/isa/host_counts.h"
#include "hw/isa/instruction.h"
#include "hw/isa/opcodes.h"
#include "hw/processors/processor.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

/// Clocks of a hand-programmed MC68000, from its manual's tables.
double clocks_of(const processors::Operations& operations) {
  return processors::clocks(operations, processors::load_processor("mc68000+compiler.factor=1000"));
}

using processors::Operation;

using Counts = std::map<Operation, std::uint64_t>;

/// The kinds that occur, with their counts.
Counts counts_of(const processors::Operations& operations) {
  Counts counts;
  for (std::size_t kind = 0; kind < processors::operation_kinds; ++kind)
    if (operations.counts[kind] > 0) counts[static_cast<Operation>(kind)] = operations.counts[kind];
  return counts;
}

/// Sum of the counts multiplied by their factors.
Counts sum_of(std::initializer_list<std::pair<std::uint64_t, const Counts*>> parts) {
  Counts sum;
  for (const auto& [times, counts] : parts)
    for (const auto& [kind, count] : *counts) sum[kind] += times * count;
  std::erase_if(sum, [](const auto& entry) { return entry.second == 0; });
  return sum;
}

// Operations of each recipe according to docs/host.md.
const std::map<std::string, Counts> expected_recipes{
    // An offset, its three products, a reciprocal and its places; one quotient aligned to its position.
    {"planes",
     {{Operation::load_long, 6},
      {Operation::add_long, 3},
      {Operation::multiply_long, 1},
      {Operation::shift_long, 1},
      {Operation::shifted_bit, 12},
      {Operation::compare_long, 2},
      {Operation::branch, 2},
      {Operation::store_long, 1}}},
    // Three sums of three products; update of a box with six sides.
    {"points",
     {{Operation::load_long, 9},
      {Operation::add_long, 6},
      {Operation::compare_long, 6},
      {Operation::branch, 6},
      {Operation::store_long, 3}}},
    // A coordinate and a number of the matrix; the end of the table.
    {"products",
     {{Operation::load_long, 2},
      {Operation::multiply_long, 1},
      {Operation::add_long, 1},
      {Operation::compare_long, 1},
      {Operation::branch_taken, 1},
      {Operation::store_long, 1}}},
    // Three sums of three products; the reciprocal of one, and two products by it, aligned.
    {"quotients",
     {{Operation::load_long, 9},
      {Operation::add_long, 6},
      {Operation::divide_long, 1},
      {Operation::multiply_long, 2},
      {Operation::shift_long, 3},
      {Operation::shifted_bit, 3 * 12},
      {Operation::compare_long, 2},
      {Operation::branch, 2},
      {Operation::store_long, 3}}},
    // A normal and a colour; three channels clamped and packed.
    {"colours",
     {{Operation::load_long, 3 + 3},
      {Operation::multiply_long, 6},
      {Operation::add_long, 5},
      {Operation::compare_long, 3},
      {Operation::branch, 3},
      {Operation::shift_long, 2},
      {Operation::shifted_bit, 8 + 16},
      {Operation::logic_long, 2},
      {Operation::store_long, 1}}},
    // Four sides in words, two depths in longs.
    {"boxes",
     {{Operation::load, 4},
      {Operation::load_long, 2},
      {Operation::compare, 4},
      {Operation::compare_long, 2},
      {Operation::branch, 6},
      {Operation::add_long, 1},
      {Operation::branch_taken, 1}}},
    // Three coefficients and four sides; two products of long and word for a corner, and two for the steps to the
    // others.
    {"tests",
     {{Operation::load_long, 3},
      {Operation::load, 4},
      {Operation::multiply, 4 * 2},
      {Operation::add_long, 10},
      {Operation::compare_long, 6},
      {Operation::branch, 6},
      {Operation::branch_taken, 1}}},
    {"values",
     {{Operation::load_long, 1},
      {Operation::add_long, 2},
      {Operation::compare_long, 1},
      {Operation::branch, 1},
      {Operation::branch_taken, 1}}},
    {"supports",
     {{Operation::load_long, 3},
      {Operation::multiply_long, 3},
      {Operation::add_long, 3},
      {Operation::compare_long, 1},
      {Operation::branch, 1},
      {Operation::branch_taken, 1}}},
    {"nodes",
     {{Operation::load, 2},
      {Operation::load_long, 1},
      {Operation::add_long, 2},
      {Operation::compare, 2},
      {Operation::branch, 2},
      {Operation::store_long, 1},
      {Operation::call, 1},
      {Operation::come_back, 1}}},
};

// Parts of writing an instruction.
const Counts counts_called{{Operation::load, 2},   {Operation::move, 2}, {Operation::compare, 2},
                           {Operation::branch, 2}, {Operation::call, 1}, {Operation::come_back, 1}};
const Counts counts_number{{Operation::load_long, 1},
                           {Operation::shift_long, 1},
                           {Operation::shifted_bit, 16},
                           {Operation::logic_long, 2},
                           {Operation::add, 1}};
const Counts counts_moved{
    {Operation::load_long, 3}, {Operation::load, 2}, {Operation::multiply, 4}, {Operation::add_long, 4}};
const Counts counts_fitted{{Operation::logic_long, 6},
                           {Operation::compare_long, 5},
                           {Operation::branch, 10},
                           {Operation::shift_long, 3},
                           {Operation::shifted_bit, 24}};
const Counts counts_squares{
    {Operation::load_long, 6}, {Operation::load, 2}, {Operation::multiply, 16}, {Operation::add_long, 16}};
const Counts counts_stored{
    {Operation::store_long, 1}, {Operation::add_long, 1}, {Operation::compare_long, 1}, {Operation::branch_taken, 1}};

const Counts counts_renamed{{Operation::load_long, 1}, {Operation::logic_long, 2}, {Operation::move, 1}};
const Counts counts_read{{Operation::load_long, 1}};

host::Written written_of(const std::vector<isa::Instruction>& instructions, unsigned link_width = 32,
                         const isa::Region& region = {}) {
  host::Writer writer(link_width);
  writer.begin(region);
  for (const isa::Instruction& one : instructions) writer.add(one);
  return writer.written();
}

double clocks_of(const isa::Instruction& instruction, unsigned link_width = 32, const isa::Region& region = {}) {
  return clocks_of(host::count_operations(written_of({instruction}, link_width, region)));
}

constexpr double called = 2 * 12 + 2 * 4 + 2 * 4 + 2 * 8 + 18 + 16;  // MOVE.W, MOVE, CMP, Bcc, BSR, RTS
constexpr double number = 16 + (8 + 2 * 16) + 2 * 8 + 4;             // MOVE.L, LSL.L by 16, AND.L and OR.L, ADDQ
constexpr double stored = 16 + 8 + 6 + 10;                           // MOVE.L, ADDQ.L, CMP.L, Bcc

}  // namespace

TEST_CASE("writing an instruction without operands takes one number in one word") {
  const isa::Instruction instruction{.opcode = isa::Opcode::enable_all};
  CHECK(clocks_of(instruction, 32) == called + number + stored);
  // A 16-bit word is stored like a long; a 64-bit word takes two stores.
  CHECK(clocks_of(instruction, 16) == called + number + stored);
  CHECK(clocks_of(instruction, 64) == called + number + 2 * stored);
}

TEST_CASE("writing a linear expression takes the clocks of its four steps") {
  constexpr double moved = 3 * 16 + 2 * 12 + 4 * 70 + 4 * 8;
  constexpr double fitted = 6 * 8 + 5 * 6 + 10 * 8 + 3 * 8 + 24 * 2;
  isa::Instruction edge{.opcode = isa::Opcode::edge_not_negative, .linear = {1, 2, 3, 20, 0}};
  // The opcode has 6 bits, width and shift 6 each, and A, B and C 20 each: 78 bits.
  CHECK(clocks_of(edge) == called + 6 * number + fitted + 3 * stored);
  CHECK(clocks_of(edge, 32, {0, 5, 8, 1}) == called + 6 * number + moved + fitted + 3 * stored);
  edge.linear.width = 40;  // two longs per coefficient, 138 bits
  CHECK(clocks_of(edge) == called + 9 * number + fitted + 5 * stored);
}

TEST_CASE("writing a field takes two numbers") {
  const isa::Instruction copy{.opcode = isa::Opcode::copy, .fields = {isa::Field{3, 8}, isa::Field{20, 8}, {}}};
  // 6 bits, plus 12 and 6 for each field: 42.
  CHECK(clocks_of(copy) == called + 5 * number + 2 * stored);
}

TEST_CASE("words of an earlier instruction are copied, with another opcode if needed") {
  using isa::Opcode;
  const isa::Field z1{0, 8};
  const isa::Linear plane{.a = 1, .b = 2, .c = 3, .width = 20};
  const isa::Instruction compared{.opcode = Opcode::linear_gt, .fields = {z1}, .linear = plane};
  const isa::Instruction loaded{.opcode = Opcode::load_linear, .fields = {z1}, .linear = plane};
  const isa::Instruction elsewhere{.opcode = Opcode::linear_eq, .fields = {isa::Field{8, 8}}, .linear = plane};
  const isa::Instruction enabled{.opcode = Opcode::enable_load, .fields = {isa::Field{30, 1}}};
  const isa::Instruction stored_there{.opcode = Opcode::enable_store, .fields = {isa::Field{30, 1}}};
  // Opcode, field, and the expression: 6 + 18 + 12 + 60 bits.
  const host::Written first = written_of({compared});
  CHECK(first == host::Written{.instructions = 1, .numbers = 7, .longs = 3, .linear = 1});
  CHECK(written_of({compared, loaded}) ==
        host::Written{.instructions = 2, .kept = 1, .kept_longs = 3, .numbers = 7, .longs = 3, .linear = 1});
  // Another field takes other words, but the expression fits already.
  CHECK(written_of({compared, elsewhere}) == host::Written{.instructions = 2, .numbers = 14, .longs = 6, .linear = 1});
  CHECK(written_of({enabled, stored_there, enabled}) ==
        host::Written{.instructions = 3, .kept = 1, .kept_longs = 1, .numbers = 4, .longs = 2});
  // Expressions are kept for a segment, other instructions for the frame.
  host::Writer writer(32);
  for (int segment = 0; segment < 2; ++segment) {
    writer.begin({0, static_cast<std::uint16_t>(segment), 8, 1});
    writer.add(compared);
    writer.add(enabled);
  }
  CHECK(
      writer.written() ==
      host::Written{.instructions = 4, .kept = 1, .kept_longs = 1, .numbers = 16, .longs = 7, .linear = 2, .moved = 1});
}

TEST_CASE("an expression that the row above has is moved by an addition") {
  const auto moved_in = [](std::uint32_t second_row, std::int64_t second_constant) {
    host::Writer writer(32);
    writer.begin({0, 4, 8, 1});
    writer.add({.opcode = isa::Opcode::edge_negative, .linear = {.a = 1, .b = 2, .c = 3, .width = 20}});
    writer.begin({0, second_row, 8, 1});
    writer.add({.opcode = isa::Opcode::edge_negative, .linear = {.a = 1, .b = 2, .c = second_constant, .width = 20}});
    return writer.written().moved;
  };
  CHECK(moved_in(5, 5) == 1);
  CHECK(moved_in(5, 3) == 2);
  CHECK(moved_in(6, 5) == 2);
}

TEST_CASE("every member of the preparation has one recipe with a positive cost") {
  isa::Preparation all;
  for (const host::Recipe& recipe : host::recipes()) {
    CHECK(all.*recipe.count == 0);
    all.*recipe.count = 1;
    CHECK(clocks_of(recipe.each) > 0);
  }
  CHECK(all == isa::Preparation{1, 1, 1, 1, 1, 1, 1, 1, 1, 1});
}

TEST_CASE("each recipe has the operations listed in docs/host.md") {
  REQUIRE(host::recipes().size() == expected_recipes.size());
  for (const host::Recipe& recipe : host::recipes()) {
    const std::string name(recipe.name);
    CAPTURE(name);
    REQUIRE(expected_recipes.contains(name));
    CHECK(counts_of(recipe.each) == expected_recipes.at(name));
  }
}

TEST_CASE("each recipe is counted by its own member of the preparation") {
  isa::Preparation preparation{.planes = 1,
                               .points = 2,
                               .colours = 3,
                               .boxes = 4,
                               .halfspaces = 5,
                               .values = 6,
                               .supports = 7,
                               .nodes = 8,
                               .products = 9,
                               .quotients = 10};
  std::map<std::string, std::uint64_t> counted;
  for (const host::Recipe& recipe : host::recipes()) counted[std::string(recipe.name)] = preparation.*recipe.count;
  CHECK(counted == std::map<std::string, std::uint64_t>{{"planes", 1},
                                                        {"points", 2},
                                                        {"colours", 3},
                                                        {"boxes", 4},
                                                        {"tests", 5},
                                                        {"values", 6},
                                                        {"supports", 7},
                                                        {"nodes", 8},
                                                        {"products", 9},
                                                        {"quotients", 10}});
}

TEST_CASE("writing instructions takes a call each and the operations of their operands") {
  const host::Written written{
      .instructions = 5, .kept = 2, .kept_longs = 4, .numbers = 10, .longs = 7, .linear = 2, .moved = 1, .squares = 1};
  CHECK(counts_of(host::count_operations(written)) == sum_of({{5, &counts_called},
                                                              {3 + 10, &counts_number},
                                                              {2, &counts_renamed},
                                                              {4, &counts_read},
                                                              {4 + 7, &counts_stored},
                                                              {2, &counts_fitted},
                                                              {1, &counts_moved},
                                                              {1, &counts_squares}}));
  CHECK(counts_of(host::model_long_operations()) == sum_of({{2, &counts_number}, {1, &counts_stored}}));
}

TEST_CASE("operands take the documented numbers and a long per 32 coefficient bits") {
  using isa::Opcode;
  const isa::Linear narrow{.a = 1, .b = 2, .c = 3, .width = 32};
  const isa::Linear wide{.a = 1, .b = 2, .c = 3, .width = 33};
  const isa::Field field{0, 8};
  const auto numbers = [](const isa::Instruction& instruction) { return written_of({instruction}).numbers; };
  CHECK(numbers({.opcode = Opcode::enable_all}) == 0);
  CHECK(numbers({.opcode = Opcode::enable_load, .fields = {field}}) == 2);
  CHECK(numbers({.opcode = Opcode::bit_and, .fields = {field, field, field}}) == 6);
  CHECK(numbers({.opcode = Opcode::set_constant, .fields = {field}, .constant = 5}) == 2 + 1);
  CHECK(numbers({.opcode = Opcode::skip_if_none, .constant = 5}) == 1);
  CHECK(numbers({.opcode = Opcode::edge_negative, .linear = narrow}) == 2 + 3);
  CHECK(numbers({.opcode = Opcode::edge_negative, .linear = wide}) == 2 + 6);
  CHECK(numbers({.opcode = Opcode::keep_max, .fields = {field}, .linear = narrow}) == 2 + 2 + 3);
  CHECK(numbers({.opcode = Opcode::squares, .linear = narrow}) == 1 + 3);
  CHECK(numbers({.opcode = Opcode::squares, .linear = wide}) == 1 + 6);
  const host::Written squares = written_of({{.opcode = Opcode::squares, .linear = narrow}});
  CHECK(squares.squares == 1);
  CHECK(squares.linear == 0);
  const host::Written edge = written_of({{.opcode = Opcode::edge_negative, .linear = narrow}});
  CHECK(edge.squares == 0);
  CHECK(edge.linear == 1);
}