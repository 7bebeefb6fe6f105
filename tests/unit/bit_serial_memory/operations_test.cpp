#include "hw/bit_serial_memory/column_logic.h"
#include "hw/bit_serial_memory/subarray.h"
#include "tests/support/test.h"
#include "tests/unit/bit_serial_memory/columns.h"

// Operations of instructions in sequences that no instruction contains, on 64 columns of a subarray: state cached from
// one operation must be discarded when the next one changes it. The reference stores one word per row.

using namespace csgsim;
using bit_serial_memory::BinaryOp;
using bit_serial_memory::Bit;
using bit_serial_memory::Chain;
using bit_serial_memory::ColumnLogic;
using bit_serial_memory::Design;
using bit_serial_memory::Latch;
using bit_serial_memory::Mask;
using bit_serial_memory::Row;
using bit_serial_memory::RowCommand;
using bit_serial_memory::RowCommands;
using bit_serial_memory::RowMap;
using bit_serial_memory::RowOp;
using bit_serial_memory::Subarray;
using bit_serial_memory::WordLines;

namespace {

constexpr std::uint32_t columns = 64;
constexpr unsigned memory_rows = 12;  ///< few, so that operations interact
constexpr std::array designs{Design::and_or_not, Design::majority, Design::latches};
constexpr std::uint64_t all_ones = ~std::uint64_t{0};

/// Reference for the operations, in all columns at once.
struct Judge {
  std::array<std::uint64_t, memory_rows> rows{};
  std::array<std::uint64_t, memory_rows> leaves{};
  std::uint64_t enable = 0;
  std::uint64_t select = 0;

  [[nodiscard]] std::uint64_t of(Bit bit) const {
    switch (bit.kind) {
      case Bit::Kind::row: return rows.at(bit.row);
      case Bit::Kind::constant: return bit.one ? all_ones : 0;
      case Bit::Kind::leaf: return leaves.at(bit.leaf);
    }
    return 0;
  }
  [[nodiscard]] std::uint64_t of(Mask mask) const { return mask == Mask::enable ? enable : select; }
  void put(Row target, std::uint64_t value, std::uint64_t where = all_ones) {
    rows.at(target) = (value & where) | (rows.at(target) & ~where);
  }
};

std::uint64_t combined(BinaryOp op, std::uint64_t a, std::uint64_t b) {
  switch (op) {
    case BinaryOp::conjunction: return a & b;
    case BinaryOp::disjunction: return a | b;
    case BinaryOp::unequal: return a ^ b;
    case BinaryOp::and_not: return a & ~b;
  }
  return 0;
}

/// Carry or borrow of a bit.
std::uint64_t next_chain(Chain chain, std::uint64_t a, std::uint64_t b, std::uint64_t k) {
  return chain == Chain::sum ? (a & b) | (a & k) | (b & k) : (~a & b) | (~a & k) | (b & k);
}

/// Random operations, sent to the design and to the reference.
class Operations {
 public:
  Operations(std::uint64_t seed, bool has_leaves, ColumnLogic& logic, Judge& judge)
      : random_(seed), has_leaves_(has_leaves), logic_(logic), judge_(judge) {}

  void put(unsigned count) {
    for (unsigned i = 0; i < count; ++i) put_one();
  }

 private:
  unsigned below(unsigned most) { return static_cast<unsigned>(random_() % most); }
  bool either() { return below(2) == 1; }
  Row row() { return static_cast<Row>(below(memory_rows)); }
  Bit bit() {
    const unsigned kind = below(has_leaves_ ? 6 : 5);
    if (kind == 5) return Bit::of_leaf(below(memory_rows));
    return kind == 4 ? Bit::constant(either()) : Bit::of_row(row());
  }
  std::vector<Bit> bits(unsigned count) {
    std::vector<Bit> all;
    for (unsigned i = 0; i < count; ++i) all.push_back(bit());
    return all;
  }
  BinaryOp two() { return static_cast<BinaryOp>(below(4)); }
  Mask mask() { return has_selected_ && either() ? Mask::select : Mask::enable; }

  void put_one() {
    switch (below(14)) {
      case 0: return assign();
      case 1: return store();
      case 2: return combine();
      case 3: return store_combined();
      case 4: return choose();
      case 5: return toggle();
      case 6: return logic_.hold(row());
      case 7: return change_enable();
      case 8: return set_enable();
      case 9: return narrow_equal();
      case 10: return drop();
      case 11: return store_sums();
      default: return put_chain();
    }
  }

  void assign() {
    const Row target = row();
    const Bit value = bit();
    const bool inverted = either();
    logic_.assign(target, value, inverted);
    judge_.put(target, inverted ? ~judge_.of(value) : judge_.of(value));
  }
  void store() {
    const Row target = row();
    const Bit value = bit();
    const Mask where = mask();
    const bool inverted = either();
    logic_.store(target, value, where, inverted);
    judge_.put(target, inverted ? ~judge_.of(value) : judge_.of(value), judge_.of(where));
  }
  void combine() {
    const Row target = row();
    const Bit a = bit();
    const Bit b = bit();
    const BinaryOp op = two();
    logic_.combine(op, target, a, b);
    judge_.put(target, combined(op, judge_.of(a), judge_.of(b)));
  }
  void store_combined() {
    const Row target = row();
    const Bit a = bit();
    const Bit b = bit();
    const BinaryOp op = two();
    const Mask where = mask();
    logic_.store_combined(op, target, a, b, where);
    judge_.put(target, combined(op, judge_.of(a), judge_.of(b)), judge_.of(where));
  }
  void choose() {
    const Row target = row();
    const Row condition = row();
    const Bit yes = bit();
    const Bit no = bit();
    logic_.choose(target, condition, yes, no);
    const std::uint64_t where = judge_.rows.at(condition);
    judge_.put(target, (judge_.of(yes) & where) | (judge_.of(no) & ~where));
  }
  void toggle() {
    const Row target = row();
    logic_.toggle(target);
    judge_.put(target, judge_.rows.at(target) ^ judge_.enable);
  }
  void change_enable() {
    if (below(3) == 0) {
      const Row target = row();
      logic_.store_enable(target);
      return judge_.put(target, judge_.enable);
    }
    const Bit value = bit();
    const BinaryOp op = two();
    logic_.change_enable(op, value);
    judge_.enable = combined(op, judge_.enable, judge_.of(value));
  }
  void set_enable() {
    if (either()) {
      logic_.invert_enable();
      judge_.enable = ~judge_.enable;
      return;
    }
    const Bit value = bit();
    logic_.set_enable(value);
    judge_.enable = judge_.of(value);
  }
  void narrow_equal() {
    const unsigned count = below(4);
    const std::vector<Bit> a = bits(count);
    const std::vector<Bit> b = bits(count);
    logic_.narrow_equal(a, b);
    for (unsigned i = 0; i < count; ++i) judge_.enable &= ~(judge_.of(a[i]) ^ judge_.of(b[i]));
  }
  void drop() {
    const std::vector<Bit> several = bits(below(4));
    const Mask where = mask();
    logic_.drop_where_any(several, where);
    std::uint64_t any = 0;
    for (const Bit one : several) any |= judge_.of(one);
    judge_.enable &= ~(any & judge_.of(where));
  }

  /// Stores a chain of sums in the columns of E, starting with 0. As in instructions, either all targets are the last
  /// operands or none is.
  void store_sums() {
    const Chain chain = either() ? Chain::sum : Chain::difference;
    logic_.begin_chain(chain, false);
    const bool adds_to_target = either();
    std::uint64_t k = 0;
    for (unsigned i = below(4); i > 0; --i) {
      const Row target = row();
      const Bit a = bit();
      const Bit other_operand = bit();
      if (!adds_to_target && other_operand.is_row(target)) continue;
      const Bit b = adds_to_target ? Bit::of_row(target) : other_operand;
      const std::uint64_t one = judge_.of(a);
      const std::uint64_t other = judge_.of(b);
      logic_.store_sum(target, a, b, Mask::enable);
      judge_.put(target, one ^ other ^ k, judge_.enable);
      k = next_chain(chain, one, other, k);
    }
  }

  /// Sums and carries in any order, followed by the queries that the end of a chain allows.
  void put_chain() {
    const Chain chain = either() ? Chain::sum : Chain::difference;
    const bool begins_with_one = either();
    logic_.begin_chain(chain, begins_with_one);
    std::uint64_t k = begins_with_one ? all_ones : 0;
    for (unsigned i = below(5); i > 0; --i) {
      const Bit a = bit();
      const Bit b = bit();
      const std::uint64_t one = judge_.of(a);
      const std::uint64_t other = judge_.of(b);
      if (either()) {
        logic_.carry(a, b);
      } else {
        const Row target = row();
        logic_.sum(target, a, b);
        judge_.put(target, one ^ other ^ k);
      }
      k = next_chain(chain, one, other, k);
    }
    end_chain(k);
  }

  void end_chain(std::uint64_t k) {
    const bool inverted = either();
    const std::uint64_t seen = inverted ? ~k : k;
    switch (below(3)) {
      case 0: {
        const Row target = row();
        logic_.assign_chain(target, inverted);
        return judge_.put(target, seen);
      }
      case 1:
        logic_.narrow_by_chain(inverted);
        judge_.enable &= seen;
        return;
      default:
        logic_.select_by_chain(inverted);
        judge_.select = judge_.enable & seen;
        has_selected_ = true;
    }
  }

  std::mt19937_64 random_;
  const bool has_leaves_;
  ColumnLogic& logic_;
  Judge& judge_;
  bool has_selected_ = false;
};

/// Sets random rows, except for those that are constant in all subarrays.
void fill(Subarray& subarray, const RowMap& map, std::mt19937_64& random) {
  for (unsigned row = 0; row < map.rows(); ++row) {
    const std::uint64_t word = random();
    if (row != map.zero() && row != map.one()) subarray.set_row(static_cast<Row>(row), {&word, 1});
  }
}

void check_operations(Design design, bool enable_latch, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const RowMap map(memory_rows, columns, 1);
  Subarray subarray(map, columns);
  fill(subarray, map, random);
  Judge judge;
  for (unsigned row = 0; row < memory_rows; ++row) judge.rows.at(row) = subarray.row(static_cast<Row>(row))[0];
  for (std::uint64_t& leaf : judge.leaves) leaf = random();
  const auto leaves = [leaf = judge.leaves](unsigned bit, std::span<std::uint64_t> words) { words[0] = leaf.at(bit); };
  judge.enable = subarray.row(map.enable())[0];
  // Latches hold unrelated values at first, except for E, which matches its row.
  const bool in_latch = design == Design::latches && enable_latch;
  subarray.execute({.op = RowOp::latch, .from = WordLines(in_latch ? map.enable() : map.zero())}, {});

  RowCommands commands;
  const std::unique_ptr<ColumnLogic> logic = make_column_logic(design, map, enable_latch, commands);
  Operations(seed, true, *logic, judge).put(10);
  logic->end();
  for (const RowCommand& command : commands) subarray.execute(command, leaves);
  for (unsigned row = 0; row < memory_rows; ++row) {
    CAPTURE(row);
    CHECK(subarray.row(static_cast<Row>(row))[0] == judge.rows.at(row));
  }
  CHECK((in_latch ? subarray.latch(Latch::enable) : subarray.row(map.enable()))[0] == judge.enable);
  CHECK(subarray.row(map.zero())[0] == 0);
  CHECK(subarray.row(map.one())[0] == all_ones);
}

RowCommands commands_of(Design design, bool enable_latch, const auto& make) {
  const RowMap map(memory_rows, columns, 1);
  RowCommands commands;
  const std::unique_ptr<ColumnLogic> logic = make_column_logic(design, map, enable_latch, commands);
  make(*logic);
  return commands;
}

}  // namespace

TEST_CASE("random operation sequences match the reference in each design") {
  for (const Design design : designs) {
    for (const bool enable_latch : {false, true}) {
      for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
        CAPTURE(fmt::format("{}, {}, {}", static_cast<int>(design), enable_latch, seed));
        check_operations(design, enable_latch, seed);
      }
    }
  }
}

TEST_CASE("the write latch is loaded once per mask and again after the mask changed") {
  for (const Design design : {Design::and_or_not, Design::majority}) {
    const auto latches = [&](const auto& make) {
      return testing::count_of(RowOp::latch, commands_of(design, true, make));
    };
    const auto store = [](ColumnLogic& logic, Mask mask) { logic.store(1, Bit::of_row(2), mask); };
    CHECK(latches([&](ColumnLogic& logic) {
            for (int i = 0; i < 3; ++i) store(logic, Mask::enable);
          }) == 1);
    CHECK(latches([&](ColumnLogic& logic) {
            for (const Mask mask : {Mask::enable, Mask::select, Mask::enable, Mask::enable}) store(logic, mask);
          }) == 3);
    CHECK(latches([&](ColumnLogic& logic) {
            store(logic, Mask::enable);
            logic.set_enable(Bit::of_row(3));
            store(logic, Mask::enable);
            store(logic, Mask::enable);
          }) == 2);
    // Rows that are not masks leave the latch unchanged.
    CHECK(latches([&](ColumnLogic& logic) {
            store(logic, Mask::enable);
            logic.assign(4, Bit::of_row(5), true);
            logic.combine(BinaryOp::unequal, 6, Bit::of_row(7), Bit::of_row(8));
            store(logic, Mask::enable);
          }) == 1);
  }
}

TEST_CASE("a masked store takes two commands with a write latch and three for a complement") {
  for (const Design design : {Design::and_or_not, Design::majority}) {
    const auto count = [&](Bit value, bool inverted) {
      return commands_of(design, true, [&](ColumnLogic& logic) { logic.store(1, value, Mask::enable, inverted); })
          .size();
    };
    for (const Bit value : {Bit::of_row(2), Bit::constant(false), Bit::constant(true), Bit::of_leaf(3)}) {
      CHECK(count(value, false) == 2);
      CHECK(count(value, true) == 3);
    }
  }
}

TEST_CASE("a row held in a latch is read once until the row or the latch is written") {
  const auto reads = [](bool enable_latch, const auto& make) {
    return testing::count_of(RowOp::read, commands_of(Design::latches, enable_latch, make));
  };
  constexpr Row held = 9;
  const auto use = [](ColumnLogic& logic) {
    logic.combine(BinaryOp::conjunction, 1, Bit::of_row(held), Bit::of_row(2));
  };
  // The held row, plus the other operand each time.
  CHECK(reads(true, [&](ColumnLogic& logic) {
          logic.hold(held);
          logic.hold(held);
          use(logic);
          use(logic);
        }) == 1 + 2);
  CHECK(reads(true, [&](ColumnLogic& logic) {
          logic.hold(held);
          logic.assign(held, Bit::constant(true));
          use(logic);
        }) == 1 + 2);
  CHECK(reads(true, [&](ColumnLogic& logic) {
          logic.hold(held);
          logic.store(held, Bit::constant(true), Mask::enable);
          use(logic);
        }) == 1 + 2);
  CHECK(reads(true, [&](ColumnLogic& logic) {
          logic.hold(held);
          logic.assign(3, Bit::constant(true));
          logic.store(4, Bit::constant(true), Mask::enable);
          use(logic);
        }) == 1 + 1);
  CHECK(reads(true, [&](ColumnLogic& logic) {
          logic.hold(held);
          logic.hold(8);
          use(logic);
        }) == 2 + 2);
  // Ungated writes read E first; a sum stored to its last operand needs the latch of the held row.
  CHECK(reads(false, [&](ColumnLogic& logic) {
          logic.hold(held);
          logic.begin_chain(Chain::sum, false);
          logic.store_sum(5, Bit::of_row(6), Bit::of_row(5), Mask::enable);
          use(logic);
        }) == 1 + 1 + 2 + 2);
}

TEST_CASE("a Bit sets only the members of its kind") {
  CHECK(Bit::of_row(3) == Bit{Bit::Kind::row, 3, false, 0});
  CHECK(Bit::constant(true) == Bit{Bit::Kind::constant, 0, true, 0});
  CHECK(Bit::constant(false) == Bit{});
  CHECK(Bit::of_leaf(3) == Bit{Bit::Kind::leaf, 0, false, 3});
  CHECK(Bit::of_row(3).is_row(3));
  CHECK_FALSE(Bit::of_row(3).is_row(2));
  CHECK_FALSE(Bit::of_leaf(0).is_row(0));
  CHECK_FALSE(Bit::constant(true).is_row(0));
}