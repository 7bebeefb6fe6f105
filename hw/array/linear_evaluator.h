#pragma once

#include <cstdint>
#include <span>

#include "hw/array/multiplier_tree.h"
#include "hw/array/plane.h"

namespace csgsim::array {

/// Bit `token.bit` of the three coefficients, as the controller sends them.
struct RootBits {
  Token token;
  bool a = false;
  bool b = false;
  bool c = false;

  constexpr bool operator==(const RootBits&) const = default;
};

/// A wire that reaches its end `length` clocks later (0 to 63).
class DelayLine {
 public:
  explicit DelayLine(unsigned length) : length_(length) {}

  /// What comes out while `bit` goes in.
  [[nodiscard]] bool out(bool bit) const { return length_ == 0 ? bit : ((bits_ >> (length_ - 1)) & 1U) != 0; }
  void shift(bool bit) { bits_ = (bits_ << 1U) | (bit ? 1U : 0U); }

 private:
  unsigned length_;
  std::uint64_t bits_ = 0;
};

/// The Linear Expression Evaluator (thesis 7.2.1): an X tree over the columns, whose leaves A*x + C each enter a Y tree
/// over the rows. Bit j of A*x + B*y + C reaches the pixels levels() clocks after bit j of A, B and C entered, for
/// instructions of any width, back to back.
class LinearEvaluator {
 public:
  explicit LinearEvaluator(PlaneShape shape);

  /// Clocks from the roots to the pixels: ceil(log2 width) + ceil(log2 height).
  [[nodiscard]] unsigned levels() const { return columns_.levels() + rows_.levels(); }

  /// Is a bit on its way to the pixels?
  [[nodiscard]] bool any_active() const { return columns_.any_active() || rows_.any_active(); }

  /// One clock. `leaves` (shape.words() words) are the registers at the pixels; they are written in clocks in which a
  /// bit reaches them, and hold otherwise. Returns whether one did. Bits beyond the row's width are undefined. With no
  /// level at all `leaves` are wires: they show `root` at once.
  bool clock(const RootBits& root, std::span<std::uint64_t> leaves);

  /// Empties the trees.
  void clear();

 private:
  bool clock_single_row(const RootBits& root, bool multiplicand, std::span<std::uint64_t> leaves);

  ColumnTree columns_;
  RowTree rows_;
  DelayLine a_;
  DelayLine b_;
};

}  // namespace csgsim::array
