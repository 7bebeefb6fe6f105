#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"

namespace csgsim::software {

/// The planes that bound a primitive over a tile of pixels: of those at the front the greatest depth is the front, of
/// those at the back the least is the back.
struct TilePlanes {
  std::vector<view::FixedLinear> fronts;
  std::vector<view::FixedLinear> backs;
  /// Edge tests: in is where the value is at least 0, or below it.
  struct Edge {
    view::FixedLinear linear;
    bool positive = true;
  };
  std::vector<Edge> edges;
  bool nowhere = false;  ///< a plane leaves nothing
};

/// The half-spaces of a primitive by what they are in the picture. Throws InputError, naming its place in the file,
/// where one that decides something does not fit the numbers of machines.
TilePlanes planes_of(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                     std::uint32_t primitive);

/// Leaves out of `all` fronts that are nowhere in the tile farther than another front, and backs that are nowhere
/// nearer than another back: a linear function that is nowhere greater at four corners is nowhere greater between them.
/// `left` has no edge tests. Returns how many planes were looked at.
std::uint64_t leave_out_hidden(const TilePlanes& all, const view::PixelRect& tile, TilePlanes& left);

}  // namespace csgsim::software
