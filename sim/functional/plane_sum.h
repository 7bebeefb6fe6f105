// A linear expression over a tile, with its bounds at the corners of blocks.
// Used by the linear kernels.
#pragma once

#include <bit>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// The sum a*x + b*y + c over a tile, with its values at the corners of its blocks.
class PlaneSum {
 public:
  /// Maximum number of bits of the numbers with which a narrow sum is compared.
  static constexpr unsigned narrow_bits = 29;

  /// c is the sum at the tile's first pixel.
  PlaneSum(const isa::Linear& linear, const TileShape& shape)
      : a_(linear.a), b_(linear.b), c_(linear.c), is_huge_(exceeds_limit(linear)) {
    if (is_huge_) {
      may_wrap_ = true;
      return;
    }
    const std::int64_t right = a_ * (shape.width() - 1);
    const std::int64_t bottom = b_ * (shape.height() - 1);
    const std::int64_t limit = std::int64_t{1} << (linear.width - 1);
    least_ = c_ + below(right) + below(bottom);
    greatest_ = c_ + above(right) + above(bottom);
    may_wrap_ = least_ < -limit || greatest_ >= limit;
    constexpr std::int64_t steps = block_side - 1;
    low_ = steps * (below(a_) + below(b_));
    spread_ = steps * (above(a_) + above(b_)) - low_;
    is_narrow_ = linear.shift <= narrow_bits && spread_ + (std::int64_t{1} << linear.shift) < std::int64_t{1} << 30U;
  }

  /// Whether the coefficients are so large that sums at corners outside the picture may exceed 64 bits; then only
  /// first_sum may be called.
  [[nodiscard]] bool is_huge() const { return is_huge_; }
  /// Whether the sum may exceed its width at some pixel of the tile.
  [[nodiscard]] bool may_wrap() const { return may_wrap_; }
  /// Whether, in every block, the differences of sums from that at the block's first pixel, plus a fraction, fit 31
  /// bits.
  [[nodiscard]] bool is_narrow() const { return is_narrow_; }

  /// Minimum and maximum over the pixels of the tile.
  [[nodiscard]] std::int64_t least() const { return least_; }
  [[nodiscard]] std::int64_t greatest() const { return greatest_; }
  /// Maximum number of bits, without sign, of the sums at all 64 x 64 pixels that a tile may have.
  [[nodiscard]] int bits() const {
    constexpr std::int64_t steps = tile_side - 1;
    const std::int64_t low = c_ + steps * (below(a_) + below(b_));
    const std::int64_t high = c_ + steps * (above(a_) + above(b_));
    return std::bit_width(static_cast<std::uint64_t>(high < 0 ? ~high : high) |
                          static_cast<std::uint64_t>(low < 0 ? ~low : low));
  }
  /// Whether the sum is constant.
  [[nodiscard]] bool is_flat() const { return a_ == 0 && b_ == 0; }

  /// The sum at the block's first pixel, modulo 2^64.
  [[nodiscard]] std::int64_t first_sum(unsigned block) const {
    const std::uint64_t x = block % blocks_per_side * block_side;
    const std::uint64_t y = block / blocks_per_side * block_side;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(c_) + static_cast<std::uint64_t>(a_) * x +
                                     static_cast<std::uint64_t>(b_) * y);
  }
  /// The minimum of the sum at the block's corners; the maximum is greater by spread().
  [[nodiscard]] std::int64_t min_sum(unsigned block) const { return first_sum(block) + low_; }
  [[nodiscard]] std::int64_t spread() const { return spread_; }
  /// Difference from one block to the next in its row.
  [[nodiscard]] std::int64_t column_step() const { return a_ * block_side; }
  /// Difference from one row of blocks to the next.
  [[nodiscard]] std::int64_t row_step() const { return b_ * block_side; }

 private:
  static constexpr std::int64_t below(std::int64_t value) { return value < 0 ? value : 0; }
  static constexpr std::int64_t above(std::int64_t value) { return value > 0 ? value : 0; }
  static constexpr bool exceeds_limit(const isa::Linear& linear) {
    constexpr std::int64_t most = std::int64_t{1} << 45U;
    return linear.a > most || linear.a < -most || linear.b > most || linear.b < -most;
  }

  std::int64_t a_;
  std::int64_t b_;
  std::int64_t c_;
  bool is_huge_;
  bool may_wrap_ = false;
  bool is_narrow_ = false;
  std::int64_t least_ = 0;
  std::int64_t greatest_ = 0;
  std::int64_t low_ = 0;
  std::int64_t spread_ = 0;
};

}  // namespace csgsim::functional
