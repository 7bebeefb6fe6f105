#pragma once

#include <optional>

#include "hw/bit_serial_memory/column_logic.h"

namespace csgsim::bit_serial_memory {

/// Common parts of the two designs that operate on three rows at a time. E is in one row, the selected columns in
/// another; the write latch, if there is one, holds a copy of either row.
class TripleRowLogic : public ColumnLogic {
 public:
  using ColumnLogic::ColumnLogic;

  void assign(Row target, Bit value, bool inverted) override;
  void store(Row target, Bit value, Mask mask, bool inverted) override;
  void combine(BinaryOp op, Row target, Bit a, Bit b) override;

 protected:
  // Word lines of the compute rows.
  [[nodiscard]] WordLine t(unsigned i) const { return {map().t(i), false}; }
  [[nodiscard]] WordLine dual(unsigned i) const { return {map().dual(i), false}; }
  [[nodiscard]] WordLine negated(unsigned i) const { return {map().dual(i), true}; }
  // Triples that are activated together.
  [[nodiscard]] WordLines lower() const { return {t(0), t(1), t(2)}; }
  [[nodiscard]] WordLines first_dual() const { return {dual(0), t(1), t(2)}; }
  [[nodiscard]] WordLines second_dual() const { return {dual(1), t(0), t(3)}; }

  [[nodiscard]] Row row_of(Mask mask) const { return mask == Mask::enable ? map().enable() : map().select(); }

  void copy(const WordLines& from, const WordLines& to);
  void activate(const WordLines& lines) { emit({.op = RowOp::activate, .from = lines}); }
  /// Copies the bit to the rows of `to`.
  void load(Bit value, const WordLines& to);
  void exclusive_or(Row target, Bit a, Bit b);

 private:
  void store_by_latch(Row target, Bit value, Mask mask, bool inverted);
  /// Invalidates the write latch if one of the written rows is the row that it copies.
  void invalidate_latch(const WordLines& written);

  std::optional<Row> latched_;  ///< row whose content is in the write latch
};

/// Separate operations: AND and OR of two rows each take four commands, NOT two, XOR seven (Seshadri et al. 2017).
class AndOrNotLogic final : public TripleRowLogic {
 public:
  using TripleRowLogic::TripleRowLogic;

  void combine(BinaryOp op, Row target, Bit a, Bit b) override;
  void choose(Row target, Row condition, Bit yes, Bit no) override;
  void begin_chain(Chain chain, bool one) override;
  void sum(Row target, Bit a, Bit b) override;
  void store_sum(Row target, Bit a, Bit b, Mask mask) override;
  void carry(Bit a, Bit b) override;
  void assign_chain(Row target, bool inverted) override;
  void narrow_by_chain(bool inverted) override;
  void select_by_chain(bool inverted) override;

 private:
  [[nodiscard]] Bit chain_bit() const { return Bit::of_row(map().carry()); }
  void invert(Row target, Bit value);

  Chain chain_ = Chain::sum;
};

/// Majorities of three rows, whose results stay where the next operation needs them: a sum bit takes eight commands, a
/// choice seven, equality four, a comparison three (Hajinazar et al. 2021).
class MajorityLogic final : public TripleRowLogic {
 public:
  using TripleRowLogic::TripleRowLogic;

  void choose(Row target, Row condition, Bit yes, Bit no) override;
  void begin_chain(Chain chain, bool one) override;
  void sum(Row target, Bit a, Bit b) override;
  void store_sum(Row target, Bit a, Bit b, Mask mask) override;
  void carry(Bit a, Bit b) override;
  void assign_chain(Row target, bool inverted) override;
  void narrow_by_chain(bool inverted) override { and_enable_with_chain(map().enable(), inverted); }
  void select_by_chain(bool inverted) override { and_enable_with_chain(map().select(), inverted); }
  void narrow_equal(std::span<const Bit> a, std::span<const Bit> b) override;

 private:
  void and_enable_with_chain(Row target, bool inverted);
  void sum_first(Row target, Bit a, Bit b);
  void sum_second(Row target, Bit a, Bit b);

  Chain chain_ = Chain::sum;
  std::optional<bool> initial_;  ///< value of the chain before its first bit
  unsigned place_ = 1;           ///< index of the dual row that holds the carry or borrow
  bool in_t2_ = false;           ///< whether T2 holds the carry or borrow as well
};

}  // namespace csgsim::bit_serial_memory
