// Integer division with rounding up or down.
// Used throughout hw and by host/view.
#pragma once

#include <concepts>
#include <type_traits>

namespace csgsim {

/// amount / piece, rounded up: the number of pieces that hold the amount. `piece` is at least 1.
template <std::unsigned_integral Amount, std::unsigned_integral Piece>
constexpr std::common_type_t<Amount, Piece> quotient_up(Amount amount, Piece piece) {
  return amount / piece + (amount % piece == 0 ? 0U : 1U);
}

/// Quotient of signed numbers, rounded towards minus infinity; `divisor` is not 0.
template <class Integer>
constexpr Integer quotient_down(Integer dividend, Integer divisor) {
  const Integer quotient = dividend / divisor;
  return quotient * divisor != dividend && (dividend < 0) != (divisor < 0) ? quotient - 1 : quotient;
}

}  // namespace csgsim
