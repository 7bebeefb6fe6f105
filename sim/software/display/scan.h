#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "sim/software/cost/operations.h"
#include "sim/software/display/phases.h"
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

/// A step to the next pixel of a span.
template <class Count>
void count_columns(Count& count, std::uint64_t columns) {
  count(Operation::branch_taken, columns);
}

/// Interpolation of a depth: the value a column further, shifted, within range. That a primitive may be thinner than a
/// step of depth is no matter of polygons: csgsim checks it so that pictures are the machines', and does not count it.
template <class Count>
void count_depths(Count& count, std::uint64_t columns, unsigned fraction_bits, std::uint64_t longs) {
  count(Operation::add_long, longs * columns);
  count(Operation::shift_long, longs * columns);
  count(Operation::shifted_bit, longs * columns * fraction_bits);
  count(Operation::compare_long, 2 * columns);
  count(Operation::branch, 2 * columns);
}

/// Calls use(column, row, event) at each pixel of a facet. Depths are counted where the method needs them.
template <class Count, class Use>
void scan(const ScreenFacets& facets, const ScreenFacet& facet, std::uint64_t longs, Ledger<Count>& ledger,
          bool needs_depths, const Use& use) {
  Count& count = ledger[Phase::scan_conversion];
  const std::size_t bounds = facets.bounds_of(facet).size();
  count_edges(count, bounds, longs);
  for (std::int32_t row = facet.pixels.y0; row <= facet.pixels.y1; ++row) {
    count_row_further(count, bounds, longs);
    const Span span =
        facets.for_row(facet, row, [&](std::int32_t column, const Event& event) { use(column, row, event); });
    const auto columns = static_cast<std::uint64_t>(std::max(0, span.columns()));
    count_columns(count, columns);
    if (needs_depths) count_depths(ledger[Phase::depth_test], columns, facets.fraction_bits, longs);
  }
}

}  // namespace csgsim::software
