#include "hw/bit_serial_memory/triple_row_logic.h"

namespace csgsim::bit_serial_memory {

void TripleRowLogic::copy(const WordLines& from, const WordLines& to) {
  emit({.op = RowOp::copy, .from = from, .to = to});
  invalidate_latch(to);
}

void TripleRowLogic::invalidate_latch(const WordLines& written) {
  for (const WordLine& line : written) {
    if (latched_ == line.row) latched_.reset();
  }
}

void TripleRowLogic::load(Bit value, const WordLines& to) {
  switch (value.kind) {
    case Bit::Kind::row: return copy(value.row, to);
    case Bit::Kind::constant: return copy(value.one ? map().one() : map().zero(), to);
    case Bit::Kind::leaf: emit({.op = RowOp::leaf_copy, .bit = value.leaf, .to = to}); return invalidate_latch(to);
  }
}

void TripleRowLogic::assign(Row target, Bit value, bool inverted) {
  if (!inverted) return load(value, target);
  load(value, negated(0));
  copy(dual(0), target);
}

/// Without a write latch, the row is rewritten with its old content where the mask is 0. For a constant, this is an AND
/// or OR.
void TripleRowLogic::store(Row target, Bit value, Mask mask, bool inverted) {
  if (enable_latch()) return store_by_latch(target, value, mask, inverted);
  const Bit where = Bit::of_row(row_of(mask));
  if (value.kind == Bit::Kind::constant)
    return combine(value.one != inverted ? BinaryOp::disjunction : BinaryOp::and_not, target, Bit::of_row(target),
                   where);
  if (!inverted) return choose(target, where.row, value, Bit::of_row(target));
  assign(map().scratch(1), value, true);
  choose(target, where.row, Bit::of_row(map().scratch(1)), Bit::of_row(target));
}

void TripleRowLogic::store_by_latch(Row target, Bit value, Mask mask, bool inverted) {
  if (latched_ != row_of(mask)) emit({.op = RowOp::latch, .from = WordLines(row_of(mask))});
  latched_ = row_of(mask);
  if (inverted) {
    load(value, negated(0));
    return emit({.op = RowOp::copy, .masked = true, .from = dual(0), .to = WordLines(target)});
  }
  RowCommand command{.op = RowOp::copy, .masked = true, .to = WordLines(target)};
  switch (value.kind) {
    case Bit::Kind::row: command.from = value.row; break;
    case Bit::Kind::constant: command.from = value.one ? map().one() : map().zero(); break;
    case Bit::Kind::leaf:
      command.op = RowOp::leaf_copy;
      command.bit = value.leaf;
      break;
  }
  emit(command);
}

void TripleRowLogic::combine(BinaryOp op, Row target, Bit a, Bit b) {
  if (op == BinaryOp::unequal) return exclusive_or(target, a, b);
  load(a, t(1));
  if (op == BinaryOp::and_not) {
    load(b, negated(0));
    load(Bit::constant(false), t(2));
    return copy(first_dual(), target);
  }
  load(b, t(0));
  load(Bit::constant(op == BinaryOp::disjunction), t(2));
  copy(lower(), target);
}

void TripleRowLogic::exclusive_or(Row target, Bit a, Bit b) {
  load(a, {negated(0), t(0)});
  load(b, {negated(1), t(1)});
  load(Bit::constant(false), {t(2), t(3)});
  activate(first_dual());
  activate(second_dual());
  load(Bit::constant(true), t(2));
  copy(lower(), target);
}

void AndOrNotLogic::invert(Row target, Bit value) { assign(target, value, true); }

void AndOrNotLogic::combine(BinaryOp op, Row target, Bit a, Bit b) {
  if (op != BinaryOp::and_not) return TripleRowLogic::combine(op, target, a, b);
  invert(map().scratch(3), b);
  TripleRowLogic::combine(BinaryOp::conjunction, target, a, Bit::of_row(map().scratch(3)));
}

void AndOrNotLogic::choose(Row target, Row condition, Bit yes, Bit no) {
  const Row kept = map().scratch(2);
  const Row taken = map().scratch(3);
  combine(BinaryOp::and_not, kept, no, Bit::of_row(condition));
  combine(BinaryOp::conjunction, taken, yes, Bit::of_row(condition));
  combine(BinaryOp::disjunction, target, Bit::of_row(taken), Bit::of_row(kept));
}

void AndOrNotLogic::begin_chain(Chain chain, bool one) {
  chain_ = chain;
  assign(map().carry(), Bit::constant(one), false);
}

/// Carry: (a and b) or (carry and (a xor b)). Borrow: (not a and b) or (borrow and not (a xor b)).
void AndOrNotLogic::sum(Row target, Bit a, Bit b) {
  const Row unequal = map().scratch(1);
  const Row both = map().scratch(2);
  combine(BinaryOp::unequal, unequal, a, b);
  if (chain_ == Chain::sum)
    combine(BinaryOp::conjunction, both, a, b);
  else
    combine(BinaryOp::and_not, both, b, a);
  combine(BinaryOp::unequal, target, Bit::of_row(unequal), chain_bit());
  combine(chain_ == Chain::sum ? BinaryOp::conjunction : BinaryOp::and_not, map().carry(), chain_bit(),
          Bit::of_row(unequal));
  combine(BinaryOp::disjunction, map().carry(), chain_bit(), Bit::of_row(both));
}

void AndOrNotLogic::store_sum(Row target, Bit a, Bit b, Mask mask) {
  const Row value = map().scratch(0);
  sum(value, a, b);
  store(target, Bit::of_row(value), mask, false);
}

/// Carry: (a and b) or (carry and (a or b)). Borrow: (not a and (b or borrow)) or (b and borrow).
void AndOrNotLogic::carry(Bit a, Bit b) {
  const Row either = map().scratch(1);
  const Row both = map().scratch(2);
  if (chain_ == Chain::sum) {
    combine(BinaryOp::disjunction, either, a, b);
    combine(BinaryOp::conjunction, both, a, b);
    combine(BinaryOp::conjunction, map().carry(), chain_bit(), Bit::of_row(either));
  } else {
    combine(BinaryOp::disjunction, either, b, chain_bit());
    combine(BinaryOp::conjunction, both, b, chain_bit());
    combine(BinaryOp::and_not, map().carry(), Bit::of_row(either), a);
  }
  combine(BinaryOp::disjunction, map().carry(), chain_bit(), Bit::of_row(both));
}

void AndOrNotLogic::assign_chain(Row target, bool inverted) { assign(target, chain_bit(), inverted); }

void AndOrNotLogic::narrow_by_chain(bool inverted) {
  change_enable(inverted ? BinaryOp::and_not : BinaryOp::conjunction, chain_bit());
}

void AndOrNotLogic::select_by_chain(bool inverted) {
  combine(inverted ? BinaryOp::and_not : BinaryOp::conjunction, map().select(), enable(), chain_bit());
}

/// Computes maj(either, maj(not condition, yes, either), 0), where either = condition or no. One copy of a 1 sets both
/// constants.
void MajorityLogic::choose(Row target, Row condition, Bit yes, Bit no) {
  load(Bit::of_row(condition), {negated(0), t(0)});
  load(Bit::constant(true), {negated(1), t(1)});
  load(no, t(2));
  activate(lower());
  load(yes, t(1));
  copy(first_dual(), t(3));
  copy(second_dual(), target);
}

void MajorityLogic::begin_chain(Chain chain, bool one) {
  chain_ = chain;
  initial_ = one;
}

/// Uses s = maj(not maj(a, b, c), a, maj(not a, b, c)), in which the first majority is the carry and the second is the
/// borrow. A sum reads its carry from the second dual row and leaves the new carry there; a borrow alternates between
/// the dual rows.
void MajorityLogic::sum(Row target, Bit a, Bit b) {
  if (initial_) {
    load(Bit::constant(*initial_), dual(1));
    initial_.reset();
    place_ = 1;
  }
  if (place_ == 1)
    sum_first(target, a, b);
  else
    sum_second(target, a, b);
  in_t2_ = false;
  if (chain_ == Chain::difference) place_ = 1 - place_;
}

void MajorityLogic::sum_first(Row target, Bit a, Bit b) {
  load(a, {negated(0), t(0)});
  load(b, {t(2), t(3)});
  copy(dual(1), t(1));
  activate(first_dual());
  activate(second_dual());
  copy(negated(1), t(0));
  load(a, t(2));
  copy(lower(), target);
}

void MajorityLogic::sum_second(Row target, Bit a, Bit b) {
  load(a, {negated(1), t(1)});
  load(b, {t(2), t(3)});
  copy(dual(0), t(0));
  activate(first_dual());
  activate(second_dual());
  copy(negated(0), t(1));
  load(a, t(2));
  copy(lower(), target);
}

/// When a sum is stored to one of its addends, the other addend is 0 in the unselected columns, so no carry arises
/// there.
void MajorityLogic::store_sum(Row target, Bit a, Bit b, Mask mask) {
  const Row value = map().scratch(0);
  if (enable_latch() || chain_ == Chain::difference || !b.is_row(target)) {
    const Row duals = map().scratch(1);
    sum(value, a, b);
    if (!enable_latch()) copy(dual(place_), duals);
    store(target, Bit::of_row(value), mask, false);
    if (!enable_latch()) copy(duals, dual(place_));
    return;
  }
  if (a.kind == Bit::Kind::constant && !a.one) return sum(target, a, b);
  combine(BinaryOp::conjunction, value, a, Bit::of_row(row_of(mask)));
  sum(target, Bit::of_row(value), b);
}

void MajorityLogic::carry(Bit a, Bit b) {
  if (chain_ == Chain::sum) {
    if (initial_) load(Bit::constant(*initial_), dual(1));
    initial_.reset();
    place_ = 1;
    load(a, t(0));
    load(b, t(3));
    return activate(second_dual());
  }
  if (initial_)
    load(Bit::constant(*initial_), t(2));
  else if (!in_t2_)
    copy(dual(place_), t(2));
  initial_.reset();
  load(a, negated(0));
  load(b, t(1));
  activate(first_dual());
  place_ = 0;
  in_t2_ = true;
}

void MajorityLogic::assign_chain(Row target, bool inverted) {
  if (initial_) return load(Bit::constant(*initial_ != inverted), target);
  copy(inverted ? negated(place_) : dual(place_), target);
}

/// Two parallel chains, for a < b and a > b, each starting with E and holding 1 while all processed bits are equal:
/// both are 1 where E is 1 and all bits are equal.
void MajorityLogic::narrow_equal(std::span<const Bit> a, std::span<const Bit> b) {
  if (a.empty()) return;
  load(enable(), {t(2), t(3)});
  for (std::size_t i = 0; i < a.size(); ++i) {
    load(a[i], {negated(0), t(0)});
    load(b[i], {negated(1), t(1)});
    activate(first_dual());
    activate(second_dual());
  }
  load(Bit::constant(false), t(1));
  copy(lower(), map().enable());
}

void MajorityLogic::and_enable_with_chain(Row target, bool inverted) {
  if (initial_) return combine(BinaryOp::conjunction, target, enable(), Bit::constant(*initial_ != inverted));
  copy(inverted ? negated(place_) : dual(place_), t(1));
  load(enable(), t(0));
  load(Bit::constant(false), t(2));
  copy(lower(), target);
}

}  // namespace csgsim::bit_serial_memory
