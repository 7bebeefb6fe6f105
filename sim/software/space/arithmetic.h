#pragma once

#include <cstdint>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// What real arithmetic takes of a processor without floating point: coordinates are longs in fixed point (assumed; the
/// thesis does not tell its numbers). Of a product of two longs the middle is kept: four products of words, added up.
template <class Count>
void count_products(Count& count, std::uint64_t times) {
  count(Operation::multiply, 4 * times);
  count(Operation::add_long, 3 * times);
  count(Operation::move, 2 * times);
}

/// A quotient of longs, two digits of a word each.
template <class Count>
void count_quotients(Count& count, std::uint64_t times) {
  count(Operation::divide, 2 * times);
  count(Operation::multiply, 2 * times);
  count(Operation::add_long, 2 * times);
}

/// Values that are read, and held against others.
template <class Count>
void count_comparisons(Count& count, std::uint64_t times) {
  count(Operation::load_long, times);
  count(Operation::compare_long, times);
  count(Operation::branch, times);
}

}  // namespace csgsim::software
