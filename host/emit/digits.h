#pragma once

#include <cstddef>
#include <vector>

namespace csgsim::emit {

/// A number as sums and differences of powers of two.
struct Digits {
  std::vector<int> plus;   ///< exponents, from the greatest down
  std::vector<int> minus;  ///< exponents, from the greatest down
  double rest = 0;         ///< the number less these
};

/// What a multiplication by the digits takes in additions: one each, and one more to turn the sum about where it
/// subtracts too.
std::size_t additions(const Digits& digits);

/// The digits of the number, to within `error`, that take the fewest additions; where several do, those with the least
/// rest. The number must not be negative, nor the error 0.
Digits fewest_digits(double number, double error);

}  // namespace csgsim::emit
