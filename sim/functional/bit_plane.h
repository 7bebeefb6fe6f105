#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "sim/functional/rect.h"

namespace csgsim::sim {

inline constexpr std::uint32_t word_bits = 64;

/// A rectangle of words of a plane, in rows. The pixel at bit b of word (row, column) is lane
/// 64 * (row * stride + column) + b counted from the block's first pixel, in planes and lanes alike.
struct WordBlock {
  std::uint64_t* words = nullptr;
  std::size_t stride = 0;   ///< words from one row to the next
  std::size_t columns = 0;  ///< words a row
  std::size_t rows = 0;
};

/// The words that hold a rectangle of pixels, counted in the array.
struct Cells {
  std::uint32_t row = 0;
  std::uint32_t rows = 0;
  std::uint32_t column = 0;
  std::uint32_t columns = 0;

  constexpr Cells() = default;
  constexpr explicit Cells(const Rect& rect) {
    if (rect.empty()) return;
    row = rect.y0;
    rows = rect.height();
    column = rect.x0 / word_bits;
    columns = (rect.x1 + word_bits - 1) / word_bits - column;
  }
  [[nodiscard]] constexpr bool holds(std::uint32_t r, std::uint32_t c) const {
    return r - row < rows && c - column < columns;
  }
};

/// Bits [from, to) of the word's 64; both may lie outside.
constexpr std::uint64_t bits_between(std::int64_t from, std::int64_t to) {
  const std::int64_t low = from < 0 ? 0 : from;
  const std::int64_t high = to > 64 ? 64 : to;
  if (low >= high) return 0;
  return (~std::uint64_t{0} >> (64 - (high - low))) << low;
}

/// One bit of every pixel, 64 pixels a word. Bits outside `bounds` are 0, whatever the storage holds there; inside, a
/// solid plane is all ones, else the words that hold the bounds are exact.
class BitPlane {
 public:
  BitPlane(std::uint32_t width, std::uint32_t height);

  [[nodiscard]] const Rect& bounds() const { return bounds_; }
  [[nodiscard]] Rect whole() const { return {0, 0, width_, height_}; }
  [[nodiscard]] bool solid() const { return solid_; }

  [[nodiscard]] std::uint64_t word(std::uint32_t row, std::uint32_t column) const {
    if (!cells_.holds(row, column)) return 0;
    return solid_ ? columns_mask(bounds_, column) : words_[offset(row, column)];
  }
  /// Changes a word within the bounds of a plane that is not solid.
  void set_word(std::uint32_t row, std::uint32_t column, std::uint64_t value) { words_[offset(row, column)] = value; }

  void clear() { set_bounds({}); }
  /// Ones in the rectangle, zeros elsewhere.
  void fill(const Rect& rect);
  void assign(const BitPlane& other);

  /// Widens the bounds to hold the rectangle too; the new part is 0. Afterwards the plane is not solid.
  void cover(const Rect& rect);
  /// Narrows the bounds to a rectangle within them, outside which the bits are 0 from now on. Unless the plane is
  /// solid, the caller has cleared those that share a word with one inside.
  void narrow(const Rect& rect);
  /// Writes the ones of a solid plane out into words.
  void materialise();

  /// The words of the rectangle, which lies within the bounds of a plane that is not solid.
  [[nodiscard]] WordBlock block(const Rect& rect);
  [[nodiscard]] WordBlock block() { return block(bounds_); }

  [[nodiscard]] std::uint32_t words_per_row() const { return words_per_row_; }
  [[nodiscard]] std::size_t offset(std::uint32_t row, std::uint32_t column) const {
    return static_cast<std::size_t>(row) * words_per_row_ + column;
  }
  /// Which pixels of a word column lie between the sides of the rectangle.
  static constexpr std::uint64_t columns_mask(const Rect& rect, std::uint32_t column) {
    const std::int64_t first = static_cast<std::int64_t>(column) * word_bits;
    return bits_between(rect.x0 - first, rect.x1 - first);
  }

 private:
  void set_bounds(const Rect& rect);

  std::uint32_t width_;
  std::uint32_t height_;
  std::uint32_t words_per_row_;
  std::unique_ptr<std::uint64_t[]> words_;
  Rect bounds_;
  Cells cells_;
  bool solid_ = false;
};

/// Where a block has ones, counted from its first pixel, and how many.
struct Tally {
  std::uint64_t ones = 0;
  Rect bounds;
};

/// Counts the ones and bounds them tightly.
Tally tally(const WordBlock& block);

/// Narrows the plane's bounds to its ones and says how many there are.
std::uint64_t settle(BitPlane& plane);

/// Where e: target := value(row, column), a word at a time. `ones` is a rectangle outside which the value is 0.
template <class Value>
void write_where(const BitPlane& e, BitPlane& target, const Rect& ones, const Value& value) {
  const Rect work = intersection(e.bounds(), hull(target.bounds(), ones));
  if (work.empty()) return;
  const bool all_seen = contains(work, target.bounds());
  target.cover(work);
  const Cells cells(work);
  for (std::uint32_t row = cells.row; row < cells.row + cells.rows; ++row)
    for (std::uint32_t column = cells.column; column < cells.column + cells.columns; ++column) {
      const std::uint64_t mask = e.word(row, column);
      if (mask == 0) continue;
      const std::uint64_t kept = target.word(row, column) & ~mask;
      target.set_word(row, column, kept | (value(row, column) & mask));
    }
  if (all_seen) settle(target);
}

}  // namespace csgsim::sim
