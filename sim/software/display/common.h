// Common steps of the display methods.
// Used by the methods that draw facet by facet.
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "hw/base/seconds.h"
#include "sim/software/coherences/sequences.h"
#include "sim/software/display/phases.h"
#include "sim/software/display/rows.h"
#include "sim/software/facets/screen_facets.h"
#include "sim/software/facets/transformation.h"
#include "sim/software/rays/longs.h"

namespace csgsim::software {

/// Memory in words: three coordinates per corner; per visible facet, a plane and edges with three coefficients of two
/// longs each, and a primitive, a rectangle and a pointer.
inline std::uint64_t words_of_polygons(const Facets& facets, const ScreenFacets& seen) {
  return 3 * facets.corners.size() + 6 * seen.linears.size() + 10 * seen.facets.size();
}

/// Performs the steps common to all methods: transforms polygons into the picture, draws, and collects counts.
/// `draw(seen, ledger, displayed)` draws and adds its memory to the words.
template <class Count, class Draw>
Displayed display_facets(const DisplaySubject& subject, const Draw& draw) {
  Displayed result;
  Ledger<Count> ledger;
  const auto begin = std::chrono::steady_clock::now();
  const ScreenFacets seen = screen_facets(subject.model, subject.geometry, subject.view, subject.facets);
  count_transformation(subject.facets.corners.size(), seen.facets.size(), seen.linears.size(),
                       ledger[Phase::transformation]);
  result.picture.seen.assign(subject.pixels(), VisibleSurface{subject.farthest(), VisibleSurface::nothing_seen});
  ledger[Phase::initialisation](Operation::store_long, 2 * subject.pixels());
  ledger[Phase::initialisation](Operation::branch_taken, subject.pixels());
  result.counts.polygons = result.counts.pieces = subject.facets.polygon_count();
  result.counts.drawn_polygons = seen.facets.size();
  result.counts.words.polygons = words_of_polygons(subject.facets, seen);
  result.counts.words.pixels = 2 * subject.pixels();
  draw(seen, ledger, result);
  result.drawing_seconds = seconds_since(begin);
  ledger.store_counts(result.counts);
  return result;
}

}  // namespace csgsim::software
