#include "host/model/hypotenuse.h"

#include <algorithm>
#include <cmath>

#include "host/model/two_doubles.h"

namespace csgsim::model {

namespace {

constexpr int half_range = 600;  ///< exponent of a power of two that scales very large or small numbers so that their
                                 ///< squares are near 1

/// The hypotenuse of numbers for which the squares, and their rounding errors, are normal doubles.
double moderate_hypotenuse(double x, double y) {
  const TwoDoubles square = exact_product(x, x) + exact_product(y, y);
  const double root = std::sqrt(square.high);
  const double rest = std::fma(-root, root, square.high) + square.low;
  return root + rest / (2.0 * root);
}

}  // namespace

double hypotenuse(double x, double y) {
  const auto [shorter, longer] = std::minmax({std::abs(x), std::abs(y)});
  if (std::isinf(x) || std::isinf(y)) return HUGE_VAL;
  if (std::isnan(x) || std::isnan(y)) return x + y;
  if (shorter <= longer * 0x1p-54) return longer;
  const int shift = longer > 0x1p500 ? -half_range : longer < 0x1p-400 ? half_range : 0;
  return std::ldexp(moderate_hypotenuse(std::ldexp(longer, shift), std::ldexp(shorter, shift)), -shift);
}

}  // namespace csgsim::model
