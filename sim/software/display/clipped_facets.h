#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/software/facets/facets.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// Where a polygon was cut: it is on that side of the plane.
struct Cut {
  std::uint32_t plane = 0;  ///< a canonical plane, or behind these a wall of cells
  bool positive = true;     ///< normal . p + offset <= 0
};

/// The facets of a model clipped against each other: no two of different primitives cross.
struct ClippedFacets {
  /// In the order of the facets that they are of. What is thinner than directories can tell directions of has the ends
  /// of its longest extent.
  Facets polygons;
  std::vector<std::uint32_t> facets;   ///< that they are of
  std::vector<std::vector<Cut>> cuts;  ///< each has a polygon of the facet on its other side too
  std::uint64_t crossing_tests = 0;    ///< pairs of polygons that were held against each other
  std::uint64_t overlap_tests = 0;     ///< of a facet and a cell
};

/// Each pair of facets that a cell of the directory has is held against each other; where they cross, exactly, both are
/// cut by each other's planes. A facet without corners gets one of its primitive's. `Count` is CountingMethod or
/// UncountedMethod.
template <class Count>
ClippedFacets clip_each_other(const Facets& facets, const facet::Geometry& geometry, const DirectoryRow& directory,
                              std::uint32_t bucket_size, Count& count);

}  // namespace csgsim::software
