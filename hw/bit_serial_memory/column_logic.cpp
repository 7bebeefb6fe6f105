#include "hw/bit_serial_memory/column_logic.h"

#include "hw/bit_serial_memory/latch_logic.h"
#include "hw/bit_serial_memory/triple_row_logic.h"

namespace csgsim::bit_serial_memory {

// These functions use scratch row 0. The designs' combine(), store() and assign() use only the other scratch rows.

void ColumnLogic::store_combined(BinaryOp op, Row target, Bit a, Bit b, Mask mask) {
  combine(op, map_.scratch(0), a, b);
  store(target, Bit::of_row(map_.scratch(0)), mask);
}

void ColumnLogic::toggle(Row target) { combine(BinaryOp::unequal, target, Bit::of_row(target), enable()); }

void ColumnLogic::change_enable(BinaryOp op, Bit value) { combine(op, map_.enable(), enable(), value); }

void ColumnLogic::set_enable(Bit value) { assign(map_.enable(), value); }

void ColumnLogic::invert_enable() { assign(map_.enable(), enable(), true); }

void ColumnLogic::narrow_equal(std::span<const Bit> a, std::span<const Bit> b) {
  for (std::size_t i = 0; i < a.size(); ++i) {
    combine(BinaryOp::unequal, map_.scratch(0), a[i], b[i]);
    change_enable(BinaryOp::and_not, Bit::of_row(map_.scratch(0)));
  }
}

void ColumnLogic::drop_where_any(std::span<const Bit> bits, Mask mask) {
  if (bits.empty()) return;
  const Row any = map_.scratch(0);
  Bit found = bits.front();
  for (const Bit bit : bits.subspan(1)) {
    combine(BinaryOp::disjunction, any, found, bit);
    found = Bit::of_row(any);
  }
  if (mask == Mask::select) {
    combine(BinaryOp::conjunction, any, found, Bit::of_row(map_.select()));
    found = Bit::of_row(any);
  }
  change_enable(BinaryOp::and_not, found);
}

void ColumnLogic::store_enable(Row target) { assign(target, enable()); }

void ColumnLogic::sense_enable() { emit({.op = RowOp::activate, .from = WordLines(map_.enable())}); }

Row ColumnLogic::enable_row() { return map_.enable(); }

std::unique_ptr<ColumnLogic> make_column_logic(Design design, const RowMap& map, bool enable_latch,
                                               RowCommands& commands) {
  switch (design) {
    case Design::and_or_not: return std::make_unique<AndOrNotLogic>(map, enable_latch, commands);
    case Design::majority: return std::make_unique<MajorityLogic>(map, enable_latch, commands);
    case Design::latches: return std::make_unique<LatchLogic>(map, enable_latch, commands);
  }
  return nullptr;
}

}  // namespace csgsim::bit_serial_memory
