#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "sim/software/display/polygons.h"
#include "sim/software/facets/screen_facets.h"

namespace csgsim::software {

/// Pieces in a picture: each a ScreenFacet that is bounded further by the planes that cut it, so that each pixel of a
/// facet is in one of its pieces.
struct ScreenPieces {
  ScreenFacets pieces;
  std::vector<std::uint32_t> begins;  ///< of each cell its first piece, and of the one after the last
};

/// The pieces of these cells, in their order, that may have pixels; none of near caps. Throws InputError for a plane
/// that cuts a facet and does not fit the numbers of machines.
ScreenPieces screen_pieces(const Polygons& polygons, std::span<const std::uint32_t> cells, const ScreenFacets& seen,
                           const facet::Geometry& geometry, const view::View& view);

}  // namespace csgsim::software
