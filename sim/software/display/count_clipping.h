// Operation counts of clipping.
// Used by clipped_facets.cpp and polygons.cpp.
#pragma once

#include <cstddef>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Counts the heights of corners above a plane: three long products each, of four word products.
template <class Count>
void count_heights(Count& count, std::size_t corners) {
  count(Operation::load_long, 6 * corners);
  count(Operation::multiply, 12 * corners);
  count(Operation::add_long, 15 * corners);
  count(Operation::compare_long, 2 * corners);
  count(Operation::branch, 2 * corners);
  count(Operation::branch_taken, corners);
}

/// Counts the intersections of edges with a plane: a two-digit quotient and three products each.
template <class Count>
void count_crossings(Count& count, std::size_t crossings) {
  count(Operation::divide, 2 * crossings);
  count(Operation::multiply, (2 + 12) * crossings);
  count(Operation::add_long, (2 + 18) * crossings);
  count(Operation::load_long, 8 * crossings);
  count(Operation::store_long, 3 * crossings);
}

/// Adds the operation counts of building a directory.
template <class Count>
void add_build_counts(Count& count, const Operations& operations) {
  for (std::size_t kind = 0; kind < operation_kinds; ++kind)
    count(static_cast<Operation>(kind), operations.counts[kind]);
}

}  // namespace csgsim::software
