#include "hw/bit_serial_memory/expression_sum.h"
#include "hw/bit_serial_memory/micro_program.h"
#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/bit_serial_memory/columns.h"

// Terms of the product of coefficient and coordinate, and bits of an expression that the trees supply, all calculated
// by hand: both levels run the same compiled commands, so lockstep cannot detect an error in them.

using namespace csgsim;
using bit_serial_memory::Expressions;
using bit_serial_memory::MicroDesign;
using bit_serial_memory::Row;
using bit_serial_memory::RowCommand;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowMap;
using bit_serial_memory::RowOp;
using bit_serial_memory::Term;
using bit_serial_memory::terms_of;

namespace {

const std::vector<Row> three{100, 101, 102};
const std::vector<Row> one{100};

Term plus(unsigned place, const std::vector<Row>& rows) { return {place, false, rows, 0, 0}; }
Term minus(unsigned place, const std::vector<Row>& rows) { return {place, true, rows, 0, 0}; }
Term where(Row coordinate, unsigned first, std::uint64_t multiple) { return {first, false, {}, coordinate, multiple}; }

constexpr isa::Linear expression{.a = 3, .b = -5, .c = 7, .width = 10, .shift = 2};
constexpr isa::Field field{8, 5};

std::vector<unsigned> leaf_bits(const MicroDesign& design, isa::Opcode opcode, isa::Field operand = field) {
  const isa::Instruction instruction{.opcode = opcode, .fields = {{operand}}, .linear = expression};
  std::vector<unsigned> bits;
  for (const RowCommand& command : micro_program(instruction, RowMap(40, 9, 7), design)) {
    if (command.op != RowOp::leaf && command.op != RowOp::leaf_copy) continue;
    // The trees hold a bit until the next one; a bit that is copied twice is sent once.
    if (bits.empty() || bits.back() != command.bit) bits.push_back(command.bit);
  }
  return bits;
}

std::vector<unsigned> up_to(unsigned last) {
  std::vector<unsigned> bits(last + 1);
  std::iota(bits.begin(), bits.end(), 0U);
  return bits;
}

std::vector<unsigned> twice(std::vector<unsigned> bits) {
  const std::vector<unsigned> once = bits;
  bits.insert(bits.end(), once.begin(), once.end());
  return bits;
}

std::vector<MicroDesign> designs_with(Expressions expressions) {
  std::vector<MicroDesign> designs;
  for (const MicroDesign& design : testing::all_designs())
    if (design.expressions == expressions) designs.push_back(design);
  return designs;
}

}  // namespace

TEST_CASE("a product adds the coordinate once per signed digit if that is cheaper") {
  // 5 = 4 + 1 adds 8 + 6 bits; the three bits of the coordinate would add 8 + 7 + 6.
  CHECK(terms_of(5, three, 8) == std::vector{plus(0, three), plus(2, three)});
  // 7 = 8 - 1 adds 8 + 5 bits.
  CHECK(terms_of(7, three, 8) == std::vector{minus(0, three), plus(3, three)});
  CHECK(terms_of(1, three, 8) == std::vector{plus(0, three)});
  CHECK(terms_of(-1, three, 8) == std::vector{minus(0, three)});
  // 11 = 16 - 4 - 1.
  CHECK(terms_of(11, {std::vector<Row>(9, 5)}, 8).size() == 3);
  // Modulo 8, 6 equals -2, and 4 is the sign bit.
  CHECK(terms_of(6, three, 3) == std::vector{minus(1, three)});
  CHECK(terms_of(4, one, 3) == std::vector{plus(2, one)});
}

TEST_CASE("a product adds the coefficient once per coordinate bit if that is cheaper") {
  // The two digits of 5 add 8 + 6 bits, the single bit of the coordinate 8.
  CHECK(terms_of(5, one, 8) == std::vector{where(100, 0, 5)});
  // 341 has five digits, which add 20 + 18 + 16 + 14 + 12 bits; three bits of the coordinate add 20 + 19 + 18.
  CHECK(terms_of(341, three, 20) == std::vector{where(100, 0, 341), where(101, 1, 682), where(102, 2, 1364)});
  // Within 9 bits the five digits add 25 bits, and two bits of the coordinate 17. Modulo 2^9, 682 is 170 and 853 is
  // 341.
  const std::vector<Row> two{100, 101};
  CHECK(terms_of(341, two, 9) == std::vector{where(100, 0, 341), where(101, 1, 170)});
  CHECK(terms_of(853, two, 9) == std::vector{where(100, 0, 341), where(101, 1, 170)});
  // Modulo 2^9, -171 is 341.
  CHECK(terms_of(-171, two, 9) == std::vector{where(100, 0, 341), where(101, 1, 170)});
  // A tie is resolved in favour of the digits.
  CHECK(terms_of(1, one, 8) == std::vector{plus(0, one)});
  // Modulo 2^6 the third multiple of 20 is 16, the fourth 32, and the fifth 0: 4 + 3 + 2 + 1 bits, compared with 4 + 2
  // for two digits.
  CHECK(terms_of(20, {std::vector<Row>(5, 9)}, 6).size() == 2);
  // A digit at the sign bit adds one bit.
  CHECK(terms_of(2, three, 2) == std::vector{plus(1, three)});
}

TEST_CASE("a product with a coefficient of zero has no terms") {
  CHECK(terms_of(0, three, 8).empty());
  CHECK(terms_of(256, three, 8).empty());
  CHECK(terms_of(5, {}, 8).empty());
  CHECK(Term{} == Term{0, false, {}, 0, 0});
}

TEST_CASE("the trees supply the fraction bits and the tested bits of F in order") {
  using isa::Opcode;
  for (const MicroDesign& design : designs_with(Expressions::trees)) {
    CAPTURE(fmt::format("{} {}", static_cast<int>(design.design), design.enable_latch));
    for (const Opcode opcode :
         {Opcode::edge_negative, Opcode::edge_not_negative, Opcode::stripe, Opcode::linear_ge, Opcode::linear_gt,
          Opcode::linear_le, Opcode::linear_lt, Opcode::linear_eq, Opcode::load_linear}) {
      CAPTURE(std::string(isa::name_of(opcode)));
      CHECK(leaf_bits(design, opcode) == up_to(9));
    }
    // Bits above the field do not affect a sum in the field.
    CHECK(leaf_bits(design, Opcode::linear_plus) == up_to(2 + 5 - 1));
    CHECK(leaf_bits(design, Opcode::linear_minus) == up_to(2 + 5 - 1));
    // The bits are compared and then stored, so the trees send them twice.
    CHECK(leaf_bits(design, Opcode::keep_max) == twice(up_to(9)));
    CHECK(leaf_bits(design, Opcode::keep_min) == twice(up_to(9)));
    CHECK(leaf_bits(design, Opcode::copy).empty());
  }
}

TEST_CASE("expressions from rows or from the host take no bits from the trees") {
  for (const Expressions expressions : {Expressions::rows, Expressions::planes}) {
    for (const MicroDesign& design : designs_with(expressions)) {
      CHECK(leaf_bits(design, isa::Opcode::keep_max).empty());
      std::vector<unsigned> received;
      const isa::Instruction load{.opcode = isa::Opcode::load_linear, .fields = {{field}}, .linear = expression};
      for (const RowCommand& command : micro_program(load, RowMap(40, 9, 7), design))
        if (command.op == RowOp::receive) received.push_back(command.bit);
      CHECK(received == (expressions == Expressions::planes ? std::vector<unsigned>{2, 3, 4, 5, 6, 7, 8, 9}
                                                            : std::vector<unsigned>{}));
    }
  }
}

TEST_CASE("an edge test from rows stores only the sign of the last addition") {
  // x has 4 rows, A = 1, B = 0: one addition over the ten bits of F. The first nine produce only a carry, with 4 or 2
  // of PIMeval's gates each, and the tenth is stored.
  const isa::Instruction edge{.opcode = isa::Opcode::edge_negative,
                              .linear = {.a = 1, .b = 0, .c = 0, .width = 10, .shift = 2}};
  const RowCommands commands = micro_program(edge, RowMap(40, 9, 7), {.design = bit_serial_memory::Design::latches});
  std::size_t writes = 0;
  for (const RowCommand& command : commands) writes += command.op == RowOp::write ? 1U : 0U;
  CHECK(writes == 2);  // the sign and E
}

TEST_CASE("clearing a memory writes each row of pixel memory and of E once") {
  for (const bit_serial_memory::Design design :
       {bit_serial_memory::Design::and_or_not, bit_serial_memory::Design::majority}) {
    const RowCommands commands = clear_program(RowMap(40, 9, 7), {.design = design});
    CHECK(commands.size() == 41);
    CHECK(testing::count_of(RowOp::copy, commands) == 41);
  }
  const RowCommands commands = clear_program(RowMap(40, 9, 7), {.design = bit_serial_memory::Design::latches});
  CHECK(testing::count_of(RowOp::write, commands) == 41);
  CHECK(testing::count_of(RowOp::logic, commands) == 42);
}

TEST_CASE("a field is sent to the host row by row from its lowest bit") {
  const RowCommands commands = bit_serial_memory::send_program({17, 3});
  REQUIRE(commands.size() == 3);
  for (unsigned bit = 0; bit < 3; ++bit) {
    CHECK(commands[bit].op == RowOp::send);
    CHECK(commands[bit].from == bit_serial_memory::WordLines(static_cast<Row>(17 + bit)));
  }
}

TEST_CASE("auxiliary rows follow pixel memory without overlap") {
  const RowMap map(256, 512, 300);
  CHECK(map.zero() == 256);
  CHECK(map.one() == 257);
  CHECK(map.enable() == 258);
  CHECK(map.sum(0) == 256 + 15);
  CHECK(map.spare(0) == 256 + 15 + 62);
  CHECK(map.x(0) == 256 + 15 + 62 + 40);
  CHECK(map.y(0) == map.x(0) + 9);
  CHECK(map.rows() == 256 + 15 + 62 + 40 + 9 + 9);
  CHECK(RowMap(256, 513, 1).rows() == 256 + 15 + 62 + 40 + 10);
  std::vector<Row> rows{map.zero(), map.one(), map.enable(), map.select(), map.carry()};
  const auto add = [&](unsigned count, const auto& row_of) {
    for (unsigned i = 0; i < count; ++i) rows.push_back(row_of(i));
  };
  add(4, [&](unsigned i) { return map.scratch(i); });
  add(4, [&](unsigned i) { return map.t(i); });
  add(2, [&](unsigned i) { return map.dual(i); });
  add(62, [&](unsigned bit) { return map.sum(bit); });
  add(40, [&](unsigned i) { return map.spare(i); });
  add(9, [&](unsigned bit) { return map.x(bit); });
  add(9, [&](unsigned bit) { return map.y(bit); });
  for (std::size_t i = 0; i < rows.size(); ++i) CHECK(rows[i] == 256 + i);
  CHECK(rows.size() == map.rows() - 256);
}

TEST_CASE("columns of a memory are numbered with the fewest possible bits") {
  using bit_serial_memory::count_bits;
  CHECK(count_bits(1) == 0);
  CHECK(count_bits(2) == 1);
  CHECK(count_bits(3) == 2);
  CHECK(count_bits(4) == 2);
  CHECK(count_bits(5) == 3);
  CHECK(count_bits(16'384) == 14);
  CHECK(count_bits(16'385) == 15);
}
