// Planes of a primitive over a tile of pixels.
// Used by the ray caster and by interval arithmetic.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"

namespace csgsim::software {

/// The planes that bound a primitive over a tile. The front is the maximum depth of the front planes, the back the
/// minimum depth of the back planes.
struct TilePlanes {
  std::vector<view::FixedLinear> fronts;
  std::vector<view::FixedLinear> backs;
  /// An edge test: a pixel is inside where the value is >= 0 if `positive`, or < 0 otherwise.
  struct Edge {
    view::FixedLinear linear;
    bool positive = true;
  };
  std::vector<Edge> edges;
  bool nowhere = false;  ///< a plane excludes the whole primitive
};

/// Classifies the half-spaces of a primitive by their role in the picture. Throws InputError with the primitive's place
/// in the file if a relevant half-space exceeds the number range of the machines.
TilePlanes planes_of(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                     std::uint32_t primitive);

/// Copies into `selected` the front planes that are farther than every other front plane somewhere in the tile, and
/// correspondingly the back planes that are nearest: a linear function that is nowhere greater at the four corners is
/// nowhere greater between them. Edge tests are not copied. Returns the number of tested planes.
std::uint64_t select_bounding(const TilePlanes& planes, const view::PixelRect& tile, TilePlanes& selected);

}  // namespace csgsim::software
