#pragma once

#include <cstddef>
#include <cstdint>

#include "hw/scan_line/packet.h"

namespace csgsim::scan_line {

/// The numbers that the ALU meets.
struct AluOperands {
  std::uint64_t x = 0;
  std::uint64_t y = 0;
  std::uint32_t field_bits = 0;  ///< of the field that x is meant to fit
};

/// What a cell's shifter and ALU have come to with the operands of a packet.
class CellAlu {
 public:
  void begin() { *this = {}; }

  /// A clock: a word moves on, or, if all lie where they are wanted, the ALU takes the next bits.
  void clock(const CellWork& work, const AluOperands& operands, const CellShape& cell);

  /// Nothing is left to do.
  [[nodiscard]] bool done(const CellWork& work, const CellShape& cell) const;

  [[nodiscard]] std::uint64_t value() const { return value_; }  ///< the low bits
  // Of a difference x - y:
  [[nodiscard]] bool less() const { return negative_x_ != negative_y_ ? negative_x_ : negative_; }  ///< with signs
  [[nodiscard]] bool below() const { return carry_; }                                               ///< without
  [[nodiscard]] bool equal() const { return !differs_; }
  [[nodiscard]] bool fits() const { return !negative_x_ && !beyond_; }  ///< x the field

 private:
  [[nodiscard]] bool moves(const CellWork& work, const CellShape& cell) const;
  void move_on(const CellWork& work, const CellShape& cell);
  void take(const CellWork& work, const AluOperands& operands, std::uint32_t count);

  std::size_t move_ = 0;     ///< of the work's
  std::uint32_t word_ = 0;   ///< of its operand
  std::uint32_t moved_ = 0;  ///< bits, of that word
  std::uint32_t taken_ = 0;  ///< bits that the ALU has gone through
  std::uint64_t value_ = 0;  ///< of these
  bool carry_ = false;       ///< out of them; of a difference the borrow
  bool differs_ = false;     ///< a bit of the difference is 1
  bool beyond_ = false;      ///< a bit of x above the field is
  bool negative_ = false;    ///< the highest bit of the value
  bool negative_x_ = false;  ///< and of the operands
  bool negative_y_ = false;
};

}  // namespace csgsim::scan_line
