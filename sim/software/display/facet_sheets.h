// Facets as exact convex polygons.
// Used by clipped_facets.cpp.
#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/software/facets/facets.h"
#include "sim/software/planes/sheet.h"
#include "sim/software/planes/whole_planes.h"

namespace csgsim::software {

/// The facets as exact convex polygons, one sheet per facet. Keeps references.
class FacetSheets {
 public:
  FacetSheets(const Facets& facets, const facet::Geometry& geometry);

  /// The region of a facet, bounded by the planes of its neighbours; empty for a facet without area.
  Region whole(std::uint32_t facet);
  [[nodiscard]] Sheet& sheet_of(std::uint32_t facet) { return sheets_[facet]; }
  [[nodiscard]] const Sheet& sheet_of(std::uint32_t facet) const { return sheets_[facet]; }
  [[nodiscard]] std::uint32_t plane_of(std::uint32_t facet) const { return facets_.facets[facet].halfspace.plane; }

  /// Whether the interiors of regions of two facets in different planes intersect; exact.
  [[nodiscard]] bool cross(std::uint32_t one, const Region& of_one, std::uint32_t other, const Region& of_other) const;

  /// Corners relative to PlaneTable::centre(), counter-clockwise as seen from outside.
  [[nodiscard]] std::vector<glm::dvec3> corner_positions(std::uint32_t facet, const Region& region) const;

 private:
  void find_neighbours(std::uint32_t primitive);

  const Facets& facets_;
  WholePlanes planes_;
  std::vector<Sheet> sheets_;
  std::vector<std::vector<facet::Halfspace>> bounds_;  ///< per facet, the half-spaces of its neighbours
};

}  // namespace csgsim::software
