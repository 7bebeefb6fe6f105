#include "host/view/fixed_point.h"

#include <algorithm>
#include <cmath>

namespace csgsim::view {

namespace {

/// 2^bits, for at most 62 bits.
double power_of_two(unsigned bits) { return static_cast<double>(std::uint64_t{1} << bits); }

}  // namespace

std::optional<std::int64_t> to_fixed(double value, unsigned fraction_bits) {
  constexpr double limit = 4611686018427387904.0;  // 2^62
  const double scaled = std::round(value * power_of_two(fraction_bits));
  if (!(std::abs(scaled) < limit)) return std::nullopt;
  return static_cast<std::int64_t>(scaled);
}

std::optional<FixedLinear> to_fixed(const RealLinear& linear, unsigned fraction_bits, std::uint32_t width,
                                    std::uint32_t height) {
  const auto a = to_fixed(linear.a, fraction_bits);
  const auto b = to_fixed(linear.b, fraction_bits);
  if (!a || !b) return std::nullopt;
  const double ulp = 1.0 / power_of_two(fraction_bits);
  const double corner = linear.at_centre - static_cast<double>(*a) * ulp * ((width - 1.0) / 2.0) -
                        static_cast<double>(*b) * ulp * ((height - 1.0) / 2.0);
  const auto c = to_fixed(corner, fraction_bits);
  if (!c) return std::nullopt;
  // Leaves room for the sum over any picture that the instruction set allows.
  constexpr double limit = 2305843009213693952.0;  // 2^61
  const double reach = std::abs(static_cast<double>(*a)) * width + std::abs(static_cast<double>(*b)) * height +
                       std::abs(static_cast<double>(*c));
  if (!(reach < limit)) return std::nullopt;
  return FixedLinear{*a, *b, *c};
}

PixelRect common(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelRect hull(const PixelRect& a, const PixelRect& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

Range range_over(const FixedLinear& linear, const PixelRect& rect) {
  const auto [ax0, ax1] = std::minmax({linear.a * rect.x0, linear.a * rect.x1});
  const auto [by0, by1] = std::minmax({linear.b * rect.y0, linear.b * rect.y1});
  return {ax0 + by0 + linear.c, ax1 + by1 + linear.c};
}

}  // namespace csgsim::view
