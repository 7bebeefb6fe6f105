#include "hw/bit_serial_memory/column_logic.h"
#include "tests/support/test.h"
#include "tests/unit/bit_serial_memory/columns.h"

// Published command counts for operands of n bits, with their sources:
//   Ambit    AND and OR 4 AAP, NOT 2, XOR 5 AAP and 2 AP: CMU-SAFARI/MIMDRAM, gem5/src/mem/dram_ctrl.cc
//   SIMDRAM  sum 8n + 1, greater 3n + 2, equal 4n + 3, choice 7n, counting AAPs and APs: the programs *-plus.c in
//            microworkloads of the same repository. Its choice overwrites an operand; ours preserves it with the same
//            number of commands.
//   PIMeval  reads, writes and logic commands: UVA-LavaLab/PIMeval-PIMbench, BITSIMD_V in pimPerfEnergyTables.cpp, with
//            its programs in bit-serial/bitSerialBitsimd.cpp

using namespace csgsim;
using bit_serial_memory::BinaryOp;
using bit_serial_memory::Bit;
using bit_serial_memory::Chain;
using bit_serial_memory::ColumnLogic;
using bit_serial_memory::Design;
using bit_serial_memory::Row;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowMap;
using bit_serial_memory::RowOp;

namespace {

constexpr std::uint32_t memory_bits = 160;
constexpr Row a = 0;
constexpr Row b = 40;
constexpr Row target = 80;
constexpr Row condition = 150;

RowCommands commands_of(Design design, const std::function<void(ColumnLogic&)>& make) {
  const RowMap map(memory_bits, 8, 8);
  RowCommands commands;
  const std::unique_ptr<ColumnLogic> logic = make_column_logic(design, map, false, commands);
  make(*logic);
  return commands;
}

Bit bit_of(Row field, unsigned bit) { return Bit::of_row(field + bit); }

void sum(ColumnLogic& logic, Chain chain, unsigned n) {
  logic.begin_chain(chain, false);
  for (unsigned bit = 0; bit < n; ++bit) logic.sum(static_cast<Row>(target + bit), bit_of(a, bit), bit_of(b, bit));
}

void compare(ColumnLogic& logic, unsigned n) {
  logic.begin_chain(Chain::difference, false);
  for (unsigned bit = 0; bit < n; ++bit) logic.carry(bit_of(a, bit), bit_of(b, bit));
  logic.assign_chain(target, false);
}

void choose(ColumnLogic& logic, unsigned n) {
  for (unsigned bit = 0; bit < n; ++bit)
    logic.choose(static_cast<Row>(target + bit), condition, bit_of(a, bit), bit_of(b, bit));
}

void narrow_equal(ColumnLogic& logic, unsigned n) {
  std::vector<Bit> first;
  std::vector<Bit> second;
  for (unsigned bit = 0; bit < n; ++bit) {
    first.push_back(bit_of(a, bit));
    second.push_back(bit_of(b, bit));
  }
  logic.narrow_equal(first, second);
}

struct Reads {
  std::size_t reads;
  std::size_t writes;
  std::size_t logic;
  bool operator==(const Reads&) const = default;
};

Reads reads_of(const RowCommands& commands) {
  return {testing::count_of(RowOp::read, commands), testing::count_of(RowOp::write, commands),
          testing::count_of(RowOp::logic, commands)};
}

constexpr std::array<unsigned, 5> widths{1, 8, 16, 31, 32};

}  // namespace

TEST_CASE("logic operations on rows take the command counts of Ambit") {
  for (const Design design : {Design::and_or_not, Design::majority}) {
    for (const BinaryOp op : {BinaryOp::conjunction, BinaryOp::disjunction}) {
      const RowCommands commands =
          commands_of(design, [&](ColumnLogic& logic) { logic.combine(op, target, bit_of(a, 0), bit_of(b, 0)); });
      CHECK(testing::count_of(RowOp::copy, commands) == 4);
      CHECK(commands.size() == 4);
    }
    const RowCommands inverted =
        commands_of(design, [](ColumnLogic& logic) { logic.assign(target, bit_of(a, 0), true); });
    CHECK(testing::count_of(RowOp::copy, inverted) == 2);
    CHECK(inverted.size() == 2);
    const RowCommands unequal = commands_of(
        design, [](ColumnLogic& logic) { logic.combine(BinaryOp::unequal, target, bit_of(a, 0), bit_of(b, 0)); });
    CHECK(testing::count_of(RowOp::copy, unequal) == 5);
    CHECK(testing::count_of(RowOp::activate, unequal) == 2);
    CHECK(unequal.size() == 7);
  }
}

TEST_CASE("majority sums take 8n + 1 commands and comparisons 3n + 2 as in SIMDRAM") {
  for (const unsigned n : widths) {
    CAPTURE(n);
    for (const Chain chain : {Chain::sum, Chain::difference})
      CHECK(commands_of(Design::majority, [&](ColumnLogic& logic) { sum(logic, chain, n); }).size() == 8 * n + 1);
    CHECK(commands_of(Design::majority, [&](ColumnLogic& logic) { compare(logic, n); }).size() == 3 * n + 2);
  }
}

TEST_CASE("majority choices take 7n commands and equality 4n + 3 as in SIMDRAM") {
  for (const unsigned n : widths) {
    CAPTURE(n);
    CHECK(commands_of(Design::majority, [&](ColumnLogic& logic) { choose(logic, n); }).size() == 7 * n);
    CHECK(commands_of(Design::majority, [&](ColumnLogic& logic) { narrow_equal(logic, n); }).size() == 4 * n + 3);
  }
}

TEST_CASE("AND-OR-NOT sums take 26n + 1 commands and differences 30n + 1") {
  for (const unsigned n : widths) {
    CHECK(commands_of(Design::and_or_not, [&](ColumnLogic& logic) { sum(logic, Chain::sum, n); }).size() == 26 * n + 1);
    CHECK(commands_of(Design::and_or_not, [&](ColumnLogic& logic) { sum(logic, Chain::difference, n); }).size() ==
          30 * n + 1);
  }
}

TEST_CASE("AND-OR-NOT comparisons take 18n + 2 commands and choices 14n") {
  for (const unsigned n : widths) {
    CHECK(commands_of(Design::and_or_not, [&](ColumnLogic& logic) { compare(logic, n); }).size() == 18 * n + 2);
    CHECK(commands_of(Design::and_or_not, [&](ColumnLogic& logic) { choose(logic, n); }).size() == 14 * n);
  }
}

TEST_CASE("sense-amplifier sums and bitwise operations take PIMeval's counts") {
  for (const unsigned n : widths) {
    CAPTURE(n);
    for (const Chain chain : {Chain::sum, Chain::difference}) {
      CHECK(reads_of(commands_of(Design::latches, [&](ColumnLogic& logic) { sum(logic, chain, n); })) ==
            Reads{2 * n, n, 3 * n + 1});
    }
    for (const BinaryOp op : {BinaryOp::conjunction, BinaryOp::disjunction, BinaryOp::unequal}) {
      CHECK(reads_of(commands_of(Design::latches, [&](ColumnLogic& logic) {
              for (unsigned bit = 0; bit < n; ++bit)
                logic.combine(op, static_cast<Row>(target + bit), bit_of(a, bit), bit_of(b, bit));
            })) == Reads{2 * n, n, 2 * n});
    }
    CHECK(reads_of(commands_of(Design::latches, [&](ColumnLogic& logic) {
            for (unsigned bit = 0; bit < n; ++bit) logic.assign(static_cast<Row>(target + bit), bit_of(a, bit), true);
          })) == Reads{n, n, n});
  }
}

TEST_CASE("a sense-amplifier comparison takes 2n + 2 logic commands and PIMeval's 3n + 2") {
  for (const unsigned n : widths) {
    CHECK(reads_of(commands_of(Design::latches, [&](ColumnLogic& logic) { compare(logic, n); })) ==
          Reads{2 * n, 1, 2 * n + 2});
  }
}

TEST_CASE("a sense-amplifier choice takes PIMeval's counts for min and one read of E") {
  for (const unsigned n : widths) {
    CHECK(reads_of(commands_of(Design::latches, [&](ColumnLogic& logic) { choose(logic, n); })) ==
          Reads{2 * n + 1, n, 2 * n + 1});
  }
}

TEST_CASE("a sense-amplifier sum with a constant takes 2n + 1 logic commands") {
  for (const unsigned n : widths) {
    CHECK(reads_of(commands_of(Design::latches, [&](ColumnLogic& logic) {
            logic.begin_chain(Chain::sum, false);
            for (unsigned bit = 0; bit < n; ++bit)
              logic.sum(static_cast<Row>(target + bit), bit_of(a, bit), Bit::constant(bit % 3 == 0));
          })) == Reads{n, n, 2 * n + 1});
  }
}
