// Fixed-point linear functions of the pixel, and rectangles of pixels.
// Used throughout the host.
#pragma once

#include <cstdint>
#include <optional>

namespace csgsim::view {

/// The integer nearest to value * 2^fraction_bits, halves away from zero; empty if the value is not finite or the
/// integer does not fit 62 bits. All conversions from double to coefficients use this function; their error is at most
/// 2^-(fraction_bits + 1).
std::optional<std::int64_t> to_fixed(double value, unsigned fraction_bits);

/// A linear function of the pixel's column x and row y, in double precision: at_centre + a (x - cx) + b (y - cy), where
/// (cx, cy) is the middle of the picture.
struct RealLinear {
  double a = 0;
  double b = 0;
  double at_centre = 0;
};

/// A*x + B*y + C with `fraction_bits` fraction bits.
struct FixedLinear {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t c = 0;
};

/// The value at a pixel, including the fraction bits. The pixel must be in the picture for which the function was made.
constexpr std::int64_t value_at(const FixedLinear& linear, std::int32_t column, std::int32_t row) {
  return linear.a * column + linear.b * row + linear.c;
}

/// The function a - b + offset.
constexpr FixedLinear difference(const FixedLinear& a, const FixedLinear& b, std::int64_t offset = 0) {
  return {a.a - b.a, a.b - b.b, a.c - b.c + offset};
}

/// Rounds each coefficient once. C is chosen after A and B, so that the error is at most 2^-(fraction_bits + 1) at the
/// middle of the picture, and grows by at most 2^-(fraction_bits + 1) per pixel of distance along x or y. Empty if a
/// coefficient does not fit.
std::optional<FixedLinear> to_fixed(const RealLinear& linear, unsigned fraction_bits, std::uint32_t width,
                                    std::uint32_t height);

/// Exact minimum and maximum of a linear function over a rectangle of pixels.
struct Range {
  std::int64_t low = 0;
  std::int64_t high = 0;
};

/// The pixels [x0, x1] x [y0, y1].
struct PixelRect {
  std::int32_t x0 = 0;
  std::int32_t y0 = 0;
  std::int32_t x1 = -1;
  std::int32_t y1 = -1;

  [[nodiscard]] bool empty() const { return x0 > x1 || y0 > y1; }
  bool operator==(const PixelRect&) const = default;
};

PixelRect common(const PixelRect& a, const PixelRect& b);
PixelRect hull(const PixelRect& a, const PixelRect& b);
Range range_over(const FixedLinear& linear, const PixelRect& rect);

}  // namespace csgsim::view
