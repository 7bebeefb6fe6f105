// Numbers as signed sums of powers of two, for multiplication by shifts and additions.
// Used by curved_light.
#pragma once

#include <cstddef>
#include <vector>

namespace csgsim::emit {

/// A number as sums and differences of powers of two.
struct Digits {
  std::vector<int> plus;   ///< exponents, descending
  std::vector<int> minus;  ///< exponents, descending
  double rest = 0;         ///< the number minus these powers
};

/// Number of additions that a multiplication by the digits takes: one for each digit, and one more to complement the
/// sum if it subtracts.
std::size_t additions(const Digits& digits);

/// The digits of `number` within `max_error` that take the fewest additions; ties are broken by the smallest rest. The
/// number must not be negative, and the error must be positive.
Digits fewest_digits(double number, double max_error);

}  // namespace csgsim::emit
