#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "hw/bit_serial_memory/figures.h"
#include "hw/bit_serial_memory/row_command.h"
#include "hw/bit_serial_memory/row_map.h"

namespace csgsim::bit_serial_memory {

/// One bit of every column: a row, a constant, or a bit of the expression from the trees.
struct Bit {
  enum class Kind : std::uint8_t { row, constant, leaf };

  Kind kind = Kind::constant;
  Row row = 0;            ///< valid for kind row
  bool one = false;       ///< valid for kind constant
  std::uint8_t leaf = 0;  ///< valid for kind leaf: number of the bit

  static constexpr Bit of_row(unsigned row) { return {Kind::row, static_cast<Row>(row), false, 0}; }
  static constexpr Bit constant(bool one) { return {Kind::constant, 0, one, 0}; }
  static constexpr Bit of_leaf(unsigned bit) { return {Kind::leaf, 0, false, static_cast<std::uint8_t>(bit)}; }

  [[nodiscard]] constexpr bool is_row(unsigned number) const { return kind == Kind::row && row == number; }
  constexpr bool operator==(const Bit&) const = default;
};

/// Operations on two bits.
enum class BinaryOp : std::uint8_t { conjunction, disjunction, unequal, and_not };

/// Columns that are written: those with E = 1, or the selected ones.
enum class Mask : std::uint8_t { enable, select };

/// The chained operation: a sum a + b + carry, or a difference a - b - borrow.
enum class Chain : std::uint8_t { sum, difference };

/// Translates operations on all columns into the row commands of a design. Targets are rows; an operand may be the
/// target. E denotes the enable bit of each column. Intermediate results may stay in the design's storage from one call
/// to the next; end() finishes each instruction.
class ColumnLogic {
 public:
  ColumnLogic(const RowMap& map, bool enable_latch, RowCommands& commands)
      : map_(map), enable_latch_(enable_latch), commands_(commands) {}
  ColumnLogic(const ColumnLogic&) = delete;
  ColumnLogic& operator=(const ColumnLogic&) = delete;
  virtual ~ColumnLogic() = default;

  virtual void end() {}

  /// target := value, complemented if `inverted`.
  virtual void assign(Row target, Bit value, bool inverted = false) = 0;
  /// target := value, complemented if `inverted`, in the columns of the mask.
  virtual void store(Row target, Bit value, Mask mask, bool inverted = false) = 0;
  /// target := a op b.
  virtual void combine(BinaryOp op, Row target, Bit a, Bit b) = 0;
  /// target := a op b in the columns of the mask.
  virtual void store_combined(BinaryOp op, Row target, Bit a, Bit b, Mask mask);
  /// target := `yes` where `condition` is 1, otherwise `no`.
  virtual void choose(Row target, Row condition, Bit yes, Bit no) = 0;
  /// target := target xor E.
  virtual void toggle(Row target);

  /// Hint that the following operations read the row often.
  virtual void hold(Row /*row*/) {}

  /// Starts a sum or difference with `one` as its carry or borrow.
  virtual void begin_chain(Chain chain, bool one) = 0;
  /// target := a + b + carry, or a - b - borrow; updates the carry or borrow.
  virtual void sum(Row target, Bit a, Bit b) = 0;
  /// Like sum(), in the columns of the mask; in other columns the chain is invalid afterwards.
  virtual void store_sum(Row target, Bit a, Bit b, Mask mask) = 0;
  /// Computes only the carry or borrow.
  virtual void carry(Bit a, Bit b) = 0;
  /// target := carry or borrow, complemented if `inverted`.
  virtual void assign_chain(Row target, bool inverted) = 0;

  /// E := E and the carry or borrow, complemented if `inverted`.
  virtual void narrow_by_chain(bool inverted) = 0;
  /// Selects the columns where E and the carry or borrow, complemented if `inverted`, are both 1.
  virtual void select_by_chain(bool inverted) = 0;
  /// E := E op value.
  virtual void change_enable(BinaryOp op, Bit value);
  /// E := value. invert_enable() does E := not E.
  virtual void set_enable(Bit value);
  virtual void invert_enable();
  /// E := E and a = b; a and b are numbers of equal width.
  virtual void narrow_equal(std::span<const Bit> a, std::span<const Bit> b);
  /// E := E and not (mask and any of `bits`).
  virtual void drop_where_any(std::span<const Bit> bits, Mask mask);
  /// target := E.
  virtual void store_enable(Row target);

  /// Copies E to the sense amplifiers.
  virtual void sense_enable();
  /// Row that holds E; it is written first if necessary.
  virtual Row enable_row();

  void emit(const RowCommand& command) { commands_.push_back(command); }
  [[nodiscard]] const RowMap& map() const { return map_; }

 protected:
  [[nodiscard]] bool enable_latch() const { return enable_latch_; }
  [[nodiscard]] Bit enable() const { return Bit::of_row(map_.enable()); }

 private:
  const RowMap& map_;
  bool enable_latch_;
  RowCommands& commands_;
};

/// Creates the logic of a design, which appends to `commands`. The referenced objects must outlive the result.
std::unique_ptr<ColumnLogic> make_column_logic(Design design, const RowMap& map, bool enable_latch,
                                               RowCommands& commands);

}  // namespace csgsim::bit_serial_memory
