#pragma once

#include <optional>

#include "hw/bit_serial_memory/column_logic.h"

namespace csgsim::bit_serial_memory {

/// Gates and latches at each sense amplifier: the operand bits are read one after another, and the result is written. E
/// is either in a row, and each instruction loads it into a latch and writes it back; or always in the latch, which
/// then gates writes. The carry alternates between two latches where that saves a command.
class LatchLogic final : public ColumnLogic {
 public:
  using ColumnLogic::ColumnLogic;

  void end() override;
  void assign(Row target, Bit value, bool inverted) override;
  void store(Row target, Bit value, Mask mask, bool inverted) override;
  void combine(BinaryOp op, Row target, Bit a, Bit b) override;
  void store_combined(BinaryOp op, Row target, Bit a, Bit b, Mask mask) override;
  void choose(Row target, Row condition, Bit yes, Bit no) override;
  void toggle(Row target) override;
  void hold(Row row) override;
  void begin_chain(Chain chain, bool one) override;
  void sum(Row target, Bit a, Bit b) override;
  void store_sum(Row target, Bit a, Bit b, Mask mask) override;
  void carry(Bit a, Bit b) override;
  void assign_chain(Row target, bool inverted) override;
  void narrow_by_chain(bool inverted) override;
  void select_by_chain(bool inverted) override;
  void change_enable(BinaryOp op, Bit value) override;
  void set_enable(Bit value) override;
  void invert_enable() override;
  void narrow_equal(std::span<const Bit> a, std::span<const Bit> b) override;
  void drop_where_any(std::span<const Bit> bits, Mask mask) override;
  void store_enable(Row target) override;
  void sense_enable() override;
  Row enable_row() override;

 private:
  void gate(Latch target, Gate function, Latch x = Latch::sense, Latch y = Latch::sense, Latch z = Latch::sense);
  void read(Row row);
  void write(Row row);
  void write_masked(Row row, Mask mask);
  Latch operand(Bit value);
  void combine_latches(BinaryOp op, Latch target, Latch a, Latch b);
  void require_enable();
  void mark_changed();
  [[nodiscard]] Latch spare() const { return carry_ == Latch::carry ? Latch::carry_2 : Latch::carry; }
  void swap_carry() { carry_ = spare(); }
  /// Leaves the sum or difference in `target`.
  void sum_into(Latch target, Bit a, Bit b);
  void add_constant_into(Latch target, Bit a, bool one);
  /// Like carry(), if one of the operands is constant over all columns.
  void carry_of_constants(Bit a, Bit b);

  Chain chain_ = Chain::sum;
  Latch carry_ = Latch::carry;
  std::optional<Row> held_;
  bool has_enable_ = false;      ///< whether the latch holds E
  bool enable_changed_ = false;  ///< whether E in the latch is newer than in the row
};

}  // namespace csgsim::bit_serial_memory
