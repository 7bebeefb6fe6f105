// Double-double arithmetic with identical results on all platforms. Used by hypotenuse, degrees and host/solids.
#pragma once

#include <cmath>

namespace csgsim::model {

/// A number as the sum of two non-overlapping doubles, with about 106 bits. The operations are those of Dekker, A
/// Floating-Point Technique for Extending the Available Precision (1971), and Shewchuk, Adaptive Precision
/// Floating-Point Arithmetic (1997). They use only additions, products, quotients and fma, which IEEE 754 rounds in the
/// same way everywhere.
struct TwoDoubles {
  double high = 0;
  double low = 0;  ///< rounding error of `high`
};

/// The exact sum.
inline TwoDoubles exact_sum(double a, double b) {
  const double sum = a + b;
  const double of_b = sum - a;
  const double of_a = sum - of_b;
  return {sum, (a - of_a) + (b - of_b)};
}

/// The exact product, unless its rounding error is below the range of doubles.
inline TwoDoubles exact_product(double a, double b) {
  const double product = a * b;
  return {product, std::fma(a, b, -product)};
}

/// Sum with an error of at most 2^-100 times the sum of the magnitudes.
inline TwoDoubles operator+(const TwoDoubles& a, const TwoDoubles& b) {
  const TwoDoubles sum = exact_sum(a.high, b.high);
  return exact_sum(sum.high, sum.low + (a.low + b.low));
}

inline TwoDoubles operator-(const TwoDoubles& a) { return {-a.high, -a.low}; }

/// Product with a relative error of at most 2^-100.
inline TwoDoubles operator*(const TwoDoubles& a, const TwoDoubles& b) {
  const TwoDoubles product = exact_product(a.high, b.high);
  return exact_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

inline TwoDoubles operator/(const TwoDoubles& a, double divisor) {
  const double quotient = a.high / divisor;
  return exact_sum(quotient, (std::fma(-quotient, divisor, a.high) + a.low) / divisor);
}

}  // namespace csgsim::model
