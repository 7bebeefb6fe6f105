#pragma once

#include <concepts>
#include <type_traits>

namespace csgsim {

/// How many pieces of that size, 1 at least, hold the amount: the quotient, rounded up.
template <std::unsigned_integral Amount, std::unsigned_integral Piece>
constexpr std::common_type_t<Amount, Piece> quotient_up(Amount amount, Piece piece) {
  return amount / piece + (amount % piece == 0 ? 0U : 1U);
}

}  // namespace csgsim
