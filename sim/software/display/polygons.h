#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"
#include "host/view/eye_space.h"
#include "sim/software/facets/facets.h"

namespace csgsim::software {

/// Where a polygon was cut: it is on that side of the plane.
struct Cut {
  std::uint32_t plane = 0;  ///< a canonical plane, or behind these a wall of cells
  bool positive = true;     ///< normal . p + offset <= 0
};

/// What clipping leaves of a facet in one place.
struct Piece {
  std::uint32_t facet = 0;          ///< index into Facets::facets
  std::vector<glm::dvec3> corners;  ///< convex, relative to PlaneTable::centre(); fewer than three have no area
  std::vector<Cut> cuts;            ///< each has a piece of the facet on its other side too
  facet::Box box;
};

/// A cell of space: halved by a wall, or with a bucket of pieces.
struct PolygonCell {
  static constexpr std::uint32_t none = 0xffffffffU;

  facet::Box box;
  std::uint32_t wall = none;  ///< index into Polygons::walls
  std::uint32_t low = none;   ///< cells on the sides of the wall
  std::uint32_t high = none;
  std::vector<Piece> bucket{};
};

/// The facets of a model clipped against each other, in buckets of a binary partition of space. PolygonCell 0 holds
/// all.
struct Polygons {
  std::vector<PolygonCell> cells;
  std::vector<facet::Plane> walls;  ///< normals along axes, to the high side
  std::size_t canonical_planes = 0;

  [[nodiscard]] std::size_t pieces() const;
  /// Cells with a bucket that is not empty.
  [[nodiscard]] std::size_t filled() const;
};

/// Cells are halved in the middle, along x, y and z in turn, until a bucket has no more pieces than that, or a limit of
/// levels is reached. In a bucket, pieces of different primitives that cross are cut by each other's planes. `Count` is
/// CountingMethod or UncountedMethod.
template <class Count>
Polygons clipped(const Facets& facets, const facet::Geometry& geometry, std::size_t bucket_size, Count& count);

/// Cells with a bucket that is not empty, the nearest first: of two that a ray meets, the one that it meets first.
struct CellOrder {
  std::vector<std::uint32_t> cells;
  std::size_t looked_at = 0;  ///< cells of any kind
};

/// `centre`: PlaneTable::centre(). What the picture cannot show is left out.
CellOrder front_to_back(const Polygons& polygons, const view::EyeSpace& eye, const glm::dvec3& centre,
                        std::uint32_t width, std::uint32_t height);

}  // namespace csgsim::software
