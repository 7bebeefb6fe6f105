// Scan conversion of facets with operation counts.
// Used by the display methods.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "sim/software/cost/operations.h"
#include "sim/software/display/phases.h"
#include "sim/software/facets/screen_facets.h"
#include "sim/software/rays/span.h"

namespace csgsim::software {

/// Counts setting up the edges of a facet: the intersection with the first row, and the increment per row as quotient
/// and remainder. A value has `longs` longs, a quotient two word digits.
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

/// Counts stepping to the next row: column and remainder of each edge, the columns between them, and the depth at the
/// first column.
template <class Count>
void count_next_row(Count& count, std::size_t bounds, std::uint64_t longs) {
  count(Operation::load_long, 4 * bounds + 2 * longs);
  count(Operation::add_long, 2 * bounds + longs);
  count(Operation::compare_long, bounds);
  count(Operation::store_long, 2 * bounds + longs);
  count(Operation::compare, bounds + 1);
  count(Operation::branch, 2 * bounds + 1);
  count(Operation::branch_taken);
}

/// Counts stepping to the next pixel of a span.
template <class Count>
void count_columns(Count& count, std::uint64_t columns) {
  count(Operation::branch_taken, columns);
}

/// Counts interpolating a depth: the value at the next column, shifted and clamped. The check whether a primitive is
/// thinner than a depth step is not part of a polygon method: csgsim performs it so that pictures equal those of the
/// machines, and does not count it.
template <class Count>
void count_depths(Count& count, std::uint64_t columns, unsigned fraction_bits, std::uint64_t longs) {
  count(Operation::add_long, longs * columns);
  count(Operation::shift_long, longs * columns);
  count(Operation::shifted_bit, longs * columns * fraction_bits);
  count(Operation::compare_long, 2 * columns);
  count(Operation::branch, 2 * columns);
}

/// Calls use(column, row, event) at each pixel of a facet. Depths are counted if the method needs them.
template <class Count, class Use>
void scan(const ScreenFacets& facets, const ScreenFacet& facet, std::uint64_t longs, Ledger<Count>& ledger,
          bool needs_depths, const Use& use) {
  Count& count = ledger[Phase::scan_conversion];
  const std::size_t bounds = facets.bounds_of(facet).size();
  count_edges(count, bounds, longs);
  for (std::int32_t row = facet.pixels.y0; row <= facet.pixels.y1; ++row) {
    count_next_row(count, bounds, longs);
    const Span span =
        facets.for_row(facet, row, [&](std::int32_t column, const Event& event) { use(column, row, event); });
    const auto columns = static_cast<std::uint64_t>(std::max(0, span.columns()));
    count_columns(count, columns);
    if (needs_depths) count_depths(ledger[Phase::depth_test], columns, facets.fraction_bits, longs);
  }
}

}  // namespace csgsim::software
