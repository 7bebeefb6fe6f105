#include "hw/host/recipes.h"

#include <doctest/doctest.h>

#include "hw/isa/instruction.h"
#include "hw/isa/opcodes.h"
#include "hw/processors/processor.h"

using namespace csgsim;

namespace {

/// Clocks of an MC68000 that is programmed by hand, by its manual's tables.
double clocks_of(const processors::Operations& operations) {
  return processors::clocks(operations, processors::load_processor("mc68000+compiler.factor=1000"));
}

constexpr double called = 2 * 12 + 2 * 4 + 2 * 4 + 2 * 8 + 18 + 16;  // MOVE.W, MOVE, CMP, Bcc, BSR, RTS
constexpr double number = 16 + (8 + 2 * 16) + 2 * 8 + 4;             // MOVE.L, LSL.L by 16, AND.L and OR.L, ADDQ
constexpr double stored = 16 + 8 + 6 + 10;                           // MOVE.L, ADDQ.L, CMP.L, Bcc

}  // namespace

TEST_CASE("an instruction without operands is a number that is put into one word") {
  const isa::Instruction instruction{.opcode = isa::Opcode::enable_all};
  CHECK(clocks_of(host::operations_of(instruction, 32)) == called + number + stored);
  // A word of 16 bits is stored as a long is; one of 64 takes two.
  CHECK(clocks_of(host::operations_of(instruction, 16)) == called + number + stored);
  CHECK(clocks_of(host::operations_of(instruction, 64)) == called + number + 2 * stored);
}

TEST_CASE("a linear expression is moved to its corner, tested, made short, and packed in as many longs as it has") {
  constexpr double moved = 3 * 16 + 2 * 12 + 4 * 70 + 4 * 8;
  constexpr double tested = 3 * 16 + 4 * 12 + 8 * 70 + 10 * 8 + 6 * 6 + 6 * 8 + 10;
  constexpr double fitted = 6 * 8 + 5 * 6 + 10 * 8 + 3 * 8 + 24 * 2;
  isa::Instruction edge{.opcode = isa::Opcode::edge_not_negative, .linear = {1, 2, 3, 20, 0}};
  // The number of the command, 6 bits; width and shift, 6 each; A, B and C of 20: 78 bits.
  CHECK(clocks_of(host::operations_of(edge, 32)) == called + 6 * number + moved + tested + fitted + 3 * stored);
  edge.linear.width = 40;  // two longs a coefficient, 138 bits
  CHECK(clocks_of(host::operations_of(edge, 32)) == called + 9 * number + moved + tested + fitted + 5 * stored);
}

TEST_CASE("a field is two numbers") {
  const isa::Instruction copy{.opcode = isa::Opcode::copy, .fields = {isa::Field{3, 8}, isa::Field{20, 8}, {}}};
  // 6 bits, and 12 and 6 for each field: 42.
  CHECK(clocks_of(host::operations_of(copy, 32)) == called + 5 * number + 2 * stored);
}

TEST_CASE("what is counted has a recipe each, that takes time") {
  isa::Preparation all;
  for (const host::Recipe& recipe : host::recipes()) {
    CHECK(all.*recipe.count == 0);
    all.*recipe.count = 1;
    CHECK(clocks_of(recipe.each) > 0);
  }
  CHECK(all == isa::Preparation{1, 1, 1, 1, 1, 1, 1, 1});
}
