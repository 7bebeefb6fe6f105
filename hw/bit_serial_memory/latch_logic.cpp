#include "hw/bit_serial_memory/latch_logic.h"

#include <utility>

namespace csgsim::bit_serial_memory {

namespace {

constexpr Latch latch_of(Mask mask) { return mask == Mask::enable ? Latch::enable : Latch::select; }

}  // namespace

void LatchLogic::gate(Latch target, Gate function, Latch x, Latch y, Latch z) {
  if (target == Latch::held) held_.reset();
  emit({.op = RowOp::logic, .gate = function, .target = target, .x = x, .y = y, .z = z});
}

void LatchLogic::read(Row row) { emit({.op = RowOp::read, .from = WordLines(row)}); }

void LatchLogic::write(Row row) {
  if (held_ == row) held_.reset();
  emit({.op = RowOp::write, .to = WordLines(row)});
}

/// Writes the content of `sense`. Without gated writes, the other columns are rewritten with the row's old content: the
/// value waits in a latch while the row is read.
void LatchLogic::write_masked(Row row, Mask mask) {
  if (held_ == row) held_.reset();
  if (enable_latch()) {
    emit({.op = RowOp::write, .masked = true, .mask = latch_of(mask), .to = WordLines(row)});
    return;
  }
  gate(spare(), Gate::move, Latch::sense);
  read(row);
  gate(Latch::sense, Gate::choose, latch_of(mask), spare(), Latch::sense);
  write(row);
}

/// Latch that holds the bit: `held`, or `sense` after loading it.
Latch LatchLogic::operand(Bit value) {
  switch (value.kind) {
    case Bit::Kind::row:
      if (held_ == value.row) return Latch::held;
      read(value.row);
      break;
    case Bit::Kind::constant: gate(Latch::sense, value.one ? Gate::one : Gate::zero); break;
    case Bit::Kind::leaf: emit({.op = RowOp::leaf, .bit = value.leaf}); break;
  }
  return Latch::sense;
}

void LatchLogic::require_enable() {
  if (enable_latch() || has_enable_) return;
  read(map().enable());
  gate(Latch::enable, Gate::move, Latch::sense);
  has_enable_ = true;
}

void LatchLogic::mark_changed() {
  has_enable_ = true;
  enable_changed_ = true;
}

void LatchLogic::end() {
  if (enable_latch() || !enable_changed_) return;
  enable_row();
}

Row LatchLogic::enable_row() {
  if (enable_latch() || enable_changed_) {
    gate(Latch::sense, Gate::move, Latch::enable);
    write(map().enable());
  }
  enable_changed_ = false;
  return map().enable();
}

void LatchLogic::sense_enable() {
  if (enable_latch()) return gate(Latch::sense, Gate::move, Latch::enable);
  read(map().enable());
}

void LatchLogic::assign(Row target, Bit value, bool inverted) {
  if (value.kind == Bit::Kind::constant) {
    gate(Latch::sense, value.one != inverted ? Gate::one : Gate::zero);
  } else if (const Latch from = operand(value); inverted || from != Latch::sense) {
    gate(Latch::sense, inverted ? Gate::invert : Gate::move, from);
  }
  write(target);
}

void LatchLogic::store(Row target, Bit value, Mask mask, bool inverted) {
  require_enable();
  if (value.kind == Bit::Kind::constant) {
    gate(Latch::sense, value.one != inverted ? Gate::one : Gate::zero);
  } else if (const Latch from = operand(value); inverted || from != Latch::sense) {
    gate(Latch::sense, inverted ? Gate::invert : Gate::move, from);
  }
  write_masked(target, mask);
}

void LatchLogic::combine_latches(BinaryOp op, Latch target, Latch a, Latch b) {
  switch (op) {
    case BinaryOp::conjunction: return gate(target, Gate::conjunction, a, b);
    case BinaryOp::disjunction: return gate(target, Gate::disjunction, a, b);
    case BinaryOp::unequal: return gate(target, Gate::unequal, a, b);
    case BinaryOp::and_not:
      gate(Latch::sense, Gate::invert, b);
      return gate(target, Gate::conjunction, a, Latch::sense);
  }
}

void LatchLogic::combine(BinaryOp op, Row target, Bit a, Bit b) {
  gate(spare(), Gate::move, operand(a));
  combine_latches(op, Latch::sense, spare(), operand(b));
  write(target);
}

void LatchLogic::store_combined(BinaryOp op, Row target, Bit a, Bit b, Mask mask) {
  require_enable();
  gate(spare(), Gate::move, operand(a));
  combine_latches(op, Latch::sense, spare(), operand(b));
  write_masked(target, mask);
}

void LatchLogic::choose(Row target, Row condition, Bit yes, Bit no) {
  hold(condition);
  gate(spare(), Gate::move, operand(yes));
  gate(Latch::sense, Gate::choose, Latch::held, spare(), operand(no));
  write(target);
}

void LatchLogic::toggle(Row target) {
  require_enable();
  read(target);
  gate(Latch::sense, Gate::unequal, Latch::sense, Latch::enable);
  write(target);
}

void LatchLogic::hold(Row row) {
  if (held_ == row) return;
  read(row);
  gate(Latch::held, Gate::move, Latch::sense);
  held_ = row;
}

void LatchLogic::begin_chain(Chain chain, bool one) {
  chain_ = chain;
  gate(carry_, one ? Gate::one : Gate::zero);
}

/// If a and the chain differ, the carry becomes b; if they are equal, the borrow becomes b. Otherwise the chain keeps
/// its value.
void LatchLogic::sum_into(Latch target, Bit a, Bit b) {
  if (chain_ == Chain::sum && b.kind == Bit::Kind::constant) return add_constant_into(target, a, b.one);
  if (chain_ == Chain::sum && a.kind == Bit::Kind::constant) return add_constant_into(target, b, a.one);
  const Latch other = spare();
  gate(other, Gate::unequal, operand(a), carry_);
  const Latch second = operand(b);
  if (chain_ == Chain::sum)
    gate(carry_, Gate::choose, other, second, carry_);
  else
    gate(carry_, Gate::choose, other, carry_, second);
  gate(target, Gate::unequal, other, second);
}

/// The carry is (a and chain) for constant 0, and (a or chain) for constant 1.
void LatchLogic::add_constant_into(Latch target, Bit a, bool one) {
  const Latch first = operand(a);
  gate(spare(), one ? Gate::disjunction : Gate::conjunction, first, carry_);
  gate(target, one ? Gate::equal : Gate::unequal, first, carry_);
  swap_carry();
}

void LatchLogic::sum(Row target, Bit a, Bit b) {
  sum_into(Latch::sense, a, b);
  write(target);
}

/// If the target was the last operand read, it is not read again: the value waits in a latch.
void LatchLogic::store_sum(Row target, Bit a, Bit b, Mask mask) {
  require_enable();
  const bool is_read = !enable_latch() && b.is_row(target) && held_ != target;
  if (!is_read) {
    sum_into(Latch::sense, a, b);
    return write_masked(target, mask);
  }
  sum_into(Latch::held, a, b);
  gate(Latch::sense, Gate::choose, latch_of(mask), Latch::held, Latch::sense);
  write(target);
}

/// Carry or borrow with one operand that is constant over all columns.
void LatchLogic::carry_of_constants(Bit a, Bit b) {
  const bool first = a.kind == Bit::Kind::constant;
  const bool one = first ? a.one : b.one;
  Latch other = operand(first ? b : a);
  if (chain_ == Chain::difference && !first) {
    gate(Latch::sense, Gate::invert, other);
    other = Latch::sense;
  }
  const bool either = chain_ == Chain::difference && first ? !one : one;
  gate(carry_, either ? Gate::disjunction : Gate::conjunction, other, carry_);
}

void LatchLogic::carry(Bit a, Bit b) {
  if (a.kind == Bit::Kind::constant || b.kind == Bit::Kind::constant) return carry_of_constants(a, b);
  gate(spare(), Gate::unequal, operand(a), carry_);
  const Latch second = operand(b);
  if (chain_ == Chain::sum)
    gate(carry_, Gate::choose, spare(), second, carry_);
  else
    gate(carry_, Gate::choose, spare(), carry_, second);
}

void LatchLogic::assign_chain(Row target, bool inverted) {
  gate(Latch::sense, inverted ? Gate::invert : Gate::move, carry_);
  write(target);
}

void LatchLogic::narrow_by_chain(bool inverted) {
  require_enable();
  if (inverted) gate(carry_, Gate::invert, carry_);
  gate(Latch::enable, Gate::conjunction, Latch::enable, carry_);
  mark_changed();
}

void LatchLogic::select_by_chain(bool inverted) {
  require_enable();
  if (inverted) gate(carry_, Gate::invert, carry_);
  gate(Latch::select, Gate::conjunction, Latch::enable, carry_);
}

void LatchLogic::change_enable(BinaryOp op, Bit value) {
  require_enable();
  combine_latches(op, Latch::enable, Latch::enable, operand(value));
  mark_changed();
}

void LatchLogic::set_enable(Bit value) {
  if (value.kind == Bit::Kind::constant)
    gate(Latch::enable, value.one ? Gate::one : Gate::zero);
  else
    gate(Latch::enable, Gate::move, operand(value));
  mark_changed();
}

void LatchLogic::invert_enable() {
  require_enable();
  gate(Latch::enable, Gate::invert, Latch::enable);
  mark_changed();
}

void LatchLogic::narrow_equal(std::span<const Bit> a, std::span<const Bit> b) {
  require_enable();
  for (std::size_t i = 0; i < a.size(); ++i) {
    gate(spare(), Gate::move, operand(a[i]));
    gate(Latch::sense, Gate::equal, spare(), operand(b[i]));
    gate(Latch::enable, Gate::conjunction, Latch::enable, Latch::sense);
  }
  mark_changed();
}

void LatchLogic::drop_where_any(std::span<const Bit> bits, Mask mask) {
  if (bits.empty()) return;
  require_enable();
  gate(spare(), Gate::move, operand(bits.front()));
  for (const Bit bit : bits.subspan(1)) gate(spare(), Gate::disjunction, spare(), operand(bit));
  if (mask == Mask::select) gate(spare(), Gate::conjunction, spare(), Latch::select);
  combine_latches(BinaryOp::and_not, Latch::enable, Latch::enable, spare());
  mark_changed();
}

void LatchLogic::store_enable(Row target) {
  require_enable();
  gate(Latch::sense, Gate::move, Latch::enable);
  write(target);
}

}  // namespace csgsim::bit_serial_memory
