// A quadratic expression over pixels.
// Used by the quadratic kernels.
#pragma once

#include <algorithm>
#include <cstdint>

#include "hw/isa/instruction.h"
#include "sim/functional/tile_bits.h"

namespace csgsim::functional {

/// The sum A*x*x + B*x*y + C*y*y + a*x + b*y + c, with x and y relative to a first pixel; A, B and C do not depend on
/// that pixel. Numbers are modulo 2^64 and read as two's complement; at pixels of a valid segment, the sum and its
/// first differences are exact.
class QuadraticSum {
 public:
  QuadraticSum(const isa::Linear& squares, const isa::Linear& linear)
      : xx_(bits(squares.a)),
        xy_(bits(squares.b)),
        yy_(bits(squares.c)),
        a_(bits(linear.a)),
        b_(bits(linear.b)),
        c_(bits(linear.c)) {}

  /// The same sum with pixel (x, y) as its first pixel.
  [[nodiscard]] QuadraticSum from(std::uint32_t x, std::uint32_t y) const {
    QuadraticSum moved = *this;
    moved.a_ += 2 * xx_ * x + xy_ * y;
    moved.b_ += 2 * yy_ * y + xy_ * x;
    moved.c_ += (xx_ * x + xy_ * y + a_) * x + (yy_ * y + b_) * y;
    return moved;
  }

  [[nodiscard]] std::uint64_t xx() const { return xx_; }
  [[nodiscard]] std::uint64_t xy() const { return xy_; }
  [[nodiscard]] std::uint64_t yy() const { return yy_; }
  [[nodiscard]] std::uint64_t a() const { return a_; }
  [[nodiscard]] std::uint64_t b() const { return b_; }
  [[nodiscard]] std::uint64_t c() const { return c_; }

  /// Whether range() can be computed in 64 bits for up to a tile's side in each direction.
  [[nodiscard]] bool can_bound() const {
    return is_below(xx_, 46) && is_below(xy_, 46) && is_below(yy_, 46) && is_below(a_, 52) && is_below(b_, 52) &&
           is_below(c_, 61);
  }

  struct Range {
    std::int64_t least = 0;
    std::int64_t greatest = 0;
  };

  /// Bounds of the sum over `width` x `height` pixels: the sum of the bounds of its parts in x, in y and in both.
  [[nodiscard]] Range range(std::uint32_t width, std::uint32_t height) const {
    const Range along_x = parabola(number(xx_), number(a_), width - 1);
    const Range along_y = parabola(number(yy_), number(b_), height - 1);
    const std::int64_t corner = number(xy_) * (width - 1) * (height - 1);
    return {number(c_) + along_x.least + along_y.least + std::min<std::int64_t>(corner, 0),
            number(c_) + along_x.greatest + along_y.greatest + std::max<std::int64_t>(corner, 0)};
  }

 private:
  static constexpr std::uint64_t bits(std::int64_t number) { return static_cast<std::uint64_t>(number); }
  static constexpr std::int64_t number(std::uint64_t bits) { return static_cast<std::int64_t>(bits); }
  static constexpr bool is_below(std::uint64_t value, unsigned exponent) {
    return value + (std::uint64_t{1} << exponent) < std::uint64_t{2} << exponent;
  }

  /// Range of square*i*i + slope*i for i = 0 to `last`.
  static Range parabola(std::int64_t square, std::int64_t slope, std::int64_t last) {
    const std::int64_t end = (square * last + slope) * last;
    Range range{std::min<std::int64_t>(end, 0), std::max<std::int64_t>(end, 0)};
    const std::int64_t first_step = square + slope;
    const std::int64_t last_step = square * (2 * last - 1) + slope;
    if (last == 0 || (first_step < 0) == (last_step < 0)) return range;
    std::int64_t value = 0;
    for (std::int64_t i = 0, step = first_step; i < last; ++i, step += 2 * square) {
      value += step;
      range = {std::min(range.least, value), std::max(range.greatest, value)};
    }
    return range;
  }

  std::uint64_t xx_;
  std::uint64_t xy_;
  std::uint64_t yy_;
  std::uint64_t a_;
  std::uint64_t b_;
  std::uint64_t c_;
};

}  // namespace csgsim::functional
