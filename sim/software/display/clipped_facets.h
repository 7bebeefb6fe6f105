// Facets clipped against each other.
// Used by list priority.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/software/facets/facets.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// A cut of a polygon; the polygon lies on the given side of the plane.
struct Cut {
  std::uint32_t plane = 0;  ///< index of a canonical plane; higher indices are walls of cells
  bool positive = true;     ///< normal . p + offset <= 0
};

/// The facets of a model clipped against each other: polygons of different primitives do not cross.
struct ClippedFacets {
  /// Polygons in the order of their facets. Polygons too thin for directories to determine directions are reduced to
  /// the ends of their longest extent.
  Facets polygons;
  std::vector<std::uint32_t> facets;   ///< facet of each polygon
  std::vector<std::vector<Cut>> cuts;  ///< for each cut, another polygon of the facet lies on the opposite side
  std::uint64_t crossing_tests = 0;    ///< tested pairs of polygons
  std::uint64_t overlap_tests = 0;     ///< tests of a facet against a cell
};

/// Tests each pair of facets in a cell of the directory; if they cross (exact test), both are cut by each other's
/// planes. A facet without corners gets one of its primitive's corners. `Count` is CountingMethod or UncountedMethod.
template <class Count>
ClippedFacets clip_facets_against_each_other(const Facets& facets, const facet::Geometry& geometry,
                                             const DirectoryRow& directory, std::uint32_t bucket_size, Count& count);

}  // namespace csgsim::software
