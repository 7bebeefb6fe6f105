// Pieces of facets in a picture.
// Used by list priority.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "sim/software/display/polygons.h"
#include "sim/software/facets/screen_facets.h"

namespace csgsim::software {

/// Pieces in a picture: each is a ScreenFacet further bounded by the planes of its cuts, so that each pixel of a facet
/// belongs to exactly one of its pieces.
struct ScreenPieces {
  ScreenFacets pieces;
  std::vector<std::uint32_t> begins;  ///< index of the first piece of each cell, and the end of the last cell
};

/// The pieces of these cells, in order, that may have pixels; near caps have none. Throws InputError if a cutting plane
/// exceeds the number range of the machines.
ScreenPieces screen_pieces(const Polygons& polygons, std::span<const std::uint32_t> cells, const ScreenFacets& seen,
                           const facet::Geometry& geometry, const view::View& view);

}  // namespace csgsim::software
