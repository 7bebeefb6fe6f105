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

/// What clipping leaves of a facet in one place.
struct Piece {
  std::uint32_t facet = 0;          ///< index into Facets::facets
  std::vector<glm::dvec3> corners;  ///< convex, relative to PlaneTable::centre(); fewer than three have no area
  std::vector<Cut> cuts;            ///< each has a piece of the facet on its other side too
  facet::Box box;
};

/// A part of space: halved by a wall, or a cell with a bucket of pieces.
struct PolygonCell {
  static constexpr std::uint32_t none = 0xffffffffU;

  facet::Box box;
  std::uint32_t wall = none;  ///< index into Polygons::walls
  std::uint32_t low = none;   ///< cells on the sides of the wall
  std::uint32_t high = none;
  std::vector<Piece> bucket{};
};

/// The facets of a model clipped against each other, in the buckets of a directory. PolygonCell 0 holds all.
struct Polygons {
  std::vector<PolygonCell> cells;
  std::vector<facet::Plane> walls;  ///< normals along axes, to the high side
  std::size_t canonical_planes = 0;
  std::uint64_t clipped = 0;         ///< polygons after clipping, before walls cut them
  std::uint64_t shared = 0;          ///< of these, those in several cells
  std::uint64_t crossing_tests = 0;  ///< pairs of polygons that were held against each other
  std::uint64_t overlap_tests = 0;   ///< of a polygon and a cell
  std::uint64_t words = 0;           ///< of 32 bits, of the directory and its buckets

  /// Pieces with an area, in all cells.
  [[nodiscard]] std::size_t pieces() const;
  /// Cells with a bucket that is not empty.
  [[nodiscard]] std::size_t filled() const;
};

/// How polygons are put into cells.
struct PolygonOptions {
  const DirectoryRow& directory;  ///< that halves space
  std::uint32_t bucket_size = 24;
};

/// Clips facets against each other and puts what is left of them into a directory; where its cells have a polygon on
/// both sides of a wall, the wall cuts it. `Count` is CountingMethod or UncountedMethod.
template <class Count>
Polygons clipped(const Facets& facets, const facet::Geometry& geometry, const PolygonOptions& options, Count& count);

/// Cells with a bucket that is not empty, the nearest first: of two that a ray meets, the one that it meets first.
struct CellOrder {
  std::vector<std::uint32_t> cells;
  std::size_t looked_at = 0;  ///< parts of space, cells among them
};

/// `centre`: PlaneTable::centre(). What the picture cannot show is left out.
CellOrder front_to_back(const Polygons& polygons, const view::EyeSpace& eye, const glm::dvec3& centre,
                        std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::software
