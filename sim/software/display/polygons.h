// Polygons in the cells of a directory.
// Used by list priority.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"
#include "host/view/eye_space.h"
#include "sim/software/display/clipped_facets.h"
#include "sim/software/space/directory.h"

namespace csgsim::software {

/// A part of a facet that remains after clipping.
struct Piece {
  std::uint32_t facet = 0;          ///< index into Facets::facets
  std::vector<glm::dvec3> corners;  ///< convex, relative to PlaneTable::centre(); fewer than three have no area
  std::vector<Cut> cuts;            ///< for each cut, another piece of the facet lies on the opposite side
  facet::Box box;
};

/// A part of space: divided by a wall, or a cell with a bucket of pieces.
struct PolygonCell {
  static constexpr std::uint32_t none = 0xffffffffU;

  facet::Box box;
  std::uint32_t wall = none;  ///< index into Polygons::walls
  std::uint32_t low = none;   ///< cells on the two sides of the wall
  std::uint32_t high = none;
  std::vector<Piece> bucket{};
};

/// The facets of a model clipped against each other, in the buckets of a directory. PolygonCell 0 is the root.
struct Polygons {
  std::vector<PolygonCell> cells;
  std::vector<facet::Plane> walls;  ///< axis-aligned, with normals to the high side
  std::size_t canonical_planes = 0;
  std::uint64_t clipped = 0;         ///< polygons after clipping, before cuts by walls
  std::uint64_t shared = 0;          ///< clipped polygons in several cells
  std::uint64_t crossing_tests = 0;  ///< tested pairs of polygons
  std::uint64_t overlap_tests = 0;   ///< tests of a polygon against a cell
  std::uint64_t words = 0;           ///< 32-bit words of the directory and its buckets

  /// Number of pieces with an area in all cells.
  [[nodiscard]] std::size_t piece_count() const;
  /// Number of cells with a non-empty bucket.
  [[nodiscard]] std::size_t filled_cells() const;
};

/// How polygons are distributed to cells.
struct PolygonOptions {
  const DirectoryRow& directory;  ///< must halve space
  std::uint32_t bucket_size = 24;
};

/// Clips facets against each other and inserts the pieces into a directory; polygons on both sides of a wall are cut by
/// it. `Count` is CountingMethod or UncountedMethod.
template <class Count>
Polygons clipped(const Facets& facets, const facet::Geometry& geometry, const PolygonOptions& options, Count& count);

/// Cells with a non-empty bucket, nearest first: of two cells on a ray, the one that it enters first precedes.
struct CellOrder {
  std::vector<std::uint32_t> cells;
  std::size_t looked_at = 0;  ///< visited parts of space, including cells
};

/// Orders the cells from front to back and omits those that the picture cannot show. `centre`: PlaneTable::centre().
CellOrder order_front_to_back(const Polygons& polygons, const view::EyeSpace& eye, const glm::dvec3& centre,
                              std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::software
