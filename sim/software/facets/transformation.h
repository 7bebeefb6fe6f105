// Operation counts of transforming polygons.
// Used by ray tracing and by the display methods.
#pragma once

#include <cstdint>

#include "sim/software/cost/operations.h"

namespace csgsim::software {

/// Counts transforming polygons into the picture in fixed point: a corner takes nine long products, of four word
/// products each, and a division by its distance; a plane three quotients of sums of two such products; an edge two
/// products.
template <class Count>
void count_transformation(std::uint64_t corners, std::uint64_t planes, std::uint64_t edges, Count& count) {
  const std::uint64_t products = 9 * corners + 6 * planes + 2 * edges;
  const std::uint64_t quotients = 2 * corners + 3 * planes;
  constexpr std::uint64_t words_of_product = 4;
  constexpr std::uint64_t digits = 2;
  count(Operation::multiply, words_of_product * products + digits * quotients);
  count(Operation::divide, digits * quotients);
  count(Operation::add_long, (words_of_product + 1) * products + digits * quotients);
  count(Operation::load_long, 2 * products + 2 * quotients);
  count(Operation::store_long, 3 * corners + 6 * planes + 6 * edges);
  count(Operation::call, corners + planes + edges);
  count(Operation::come_back, corners + planes + edges);
}

}  // namespace csgsim::software
