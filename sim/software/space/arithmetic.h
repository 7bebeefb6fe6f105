// Operation counts of fixed-point arithmetic.
// Used by directories, ray tracing and the counts of meshes.
#pragma once

#include <cstdint>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Counts products on a processor without floating point. Coordinates are fixed-point longs (an assumption; the thesis
/// does not specify its numbers). A product keeps the middle of two longs' product: four word products,
/// added up.
template <class Count>
void count_products(Count& count, std::uint64_t times) {
  count(Operation::multiply, 4 * times);
  count(Operation::add_long, 3 * times);
  count(Operation::move, 2 * times);
}

/// Counts divisions of longs; each quotient has two digits of a word each.
template <class Count>
void count_quotients(Count& count, std::uint64_t times) {
  count(Operation::divide, 2 * times);
  count(Operation::multiply, 2 * times);
  count(Operation::add_long, 2 * times);
}

/// Counts loading values and comparing them with others.
template <class Count>
void count_comparisons(Count& count, std::uint64_t times) {
  count(Operation::load_long, times);
  count(Operation::compare_long, times);
  count(Operation::branch, times);
}

}  // namespace csgsim::software
