#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "sim/software/cost/operations.h"
#include "sim/software/facets/screen_facets.h"
#include "sim/software/rays/span.h"

namespace csgsim::software {

/// Setting up the edges of a facet for scan-conversion: where each meets the first row, and how far it goes in a row,
/// by quotient and remainder. A value has so many longs, a quotient two digits of a word.
template <class Count>
void count_edges(Count& count, std::size_t bounds, std::uint64_t longs) {
  constexpr std::uint64_t digits = 2;
  count(Operation::load_long, 3 * longs * bounds);
  count(Operation::multiply, 2 * longs * bounds);
  count(Operation::divide, 2 * digits * bounds);
  count(Operation::multiply, 2 * digits * bounds);
  count(Operation::add_long, (2 * digits + 2 * longs) * bounds);
  count(Operation::store_long, 4 * bounds);
}

/// A row further: column and remainder of each edge, the columns between them, the depth at the first of these.
template <class Count>
void count_row_further(Count& count, std::size_t bounds, std::uint64_t longs) {
  count(Operation::load_long, 4 * bounds + 2 * longs);
  count(Operation::add_long, 2 * bounds + longs);
  count(Operation::compare_long, bounds);
  count(Operation::store_long, 2 * bounds + longs);
  count(Operation::compare, bounds + 1);
  count(Operation::branch, 2 * bounds + 1);
  count(Operation::branch_taken);
}

/// A depth at a column: the value a column further, shifted, within range, and held against so many opposites.
template <class Count>
void count_depth(Count& count, std::size_t opposites, unsigned fraction_bits, std::uint64_t longs) {
  count(Operation::add_long, longs);
  for (std::uint64_t i = 0; i < longs; ++i) count.shift(fraction_bits);
  count(Operation::compare_long, 2);
  count(Operation::branch, 2);
  count(Operation::branch_taken);
  for (std::size_t i = 0; i < opposites; ++i) {
    count(Operation::load_long, 2 * longs);
    count(Operation::add_long, longs);
    count(Operation::store_long, longs);
    for (std::uint64_t shifted = 0; shifted < longs; ++shifted) count.shift(fraction_bits);
    count(Operation::compare_long);
    count(Operation::branch);
  }
}

/// Calls use(column, row, event) at each pixel of a facet.
template <class Count, class Use>
void scan(const ScreenFacets& facets, const ScreenFacet& facet, std::uint64_t longs, Count& count, const Use& use) {
  const std::size_t bounds = facets.bounds_of(facet).size();
  const std::size_t opposites = facets.opposites_of(facet).size();
  count_edges(count, bounds, longs);
  for (std::int32_t row = facet.pixels.y0; row <= facet.pixels.y1; ++row) {
    count_row_further(count, bounds, longs);
    const Span span =
        facets.for_row(facet, row, [&](std::int32_t column, const Event& event) { use(column, row, event); });
    if constexpr (Count::counts) {
      for (std::int32_t i = 0; i < span.columns(); ++i) count_depth(count, opposites, facets.fraction_bits, longs);
    }
  }
}

}  // namespace csgsim::software
