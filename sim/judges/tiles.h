// Tiles of a picture and the primitives that matter in them.
// Used by exact_truth.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/judges/sight.h"

namespace csgsim::judges {

/// The pixels [x0, x1) x [y0, y1).
struct Tile {
  std::uint32_t x0 = 0;
  std::uint32_t y0 = 0;
  std::uint32_t x1 = 0;
  std::uint32_t y1 = 0;

  [[nodiscard]] std::uint32_t width() const { return x1 - x0; }
  [[nodiscard]] std::uint32_t height() const { return y1 - y0; }
};

/// Consecutive half-spaces or quadrics of a list.
struct Run {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// The half-spaces and quadrics of a primitive that can matter somewhere in a tile.
struct Piece {
  std::uint32_t primitive = 0;
  Run edges;
  Run fronts;
  Run backs;
  Run quadrics;
};

/// The primitives that can matter somewhere in a tile, in tree order.
struct Pieces {
  std::vector<Piece> pieces;
  std::vector<facet::Halfspace> halfspaces;
  std::vector<facet::QuadricSide> quadrics;

  [[nodiscard]] std::span<const facet::Halfspace> of(Run run) const {
    return std::span(halfspaces).subspan(run.begin, run.end - run.begin);
  }
  [[nodiscard]] std::span<const facet::QuadricSide> quadrics_in(const Piece& piece) const {
    return std::span(quadrics).subspan(piece.quadrics.begin, piece.quadrics.end - piece.quadrics.begin);
  }
};

/// All half-spaces and quadrics of all primitives. In perspective, the near plane is added as a front of each, and the
/// horizon as a back of those with quadrics.
Pieces all_pieces(const facet::Geometry& geometry, const Sight& sight);

/// Drops half-spaces that contain the tile, fronts with another front behind them all over the tile, backs with another
/// back in front of them, and primitives outside the tile. Quadrics are kept. Error bounds ensure that nothing that
/// matters is dropped. `width` and `height` are those of the picture.
Pieces prune_to_tile(const Pieces& pieces, const Sight& sight, const Tile& tile, std::uint32_t width,
                     std::uint32_t height);

}  // namespace csgsim::judges
