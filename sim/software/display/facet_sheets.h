#pragma once

#include <cstdint>
#include <vector>

#include "host/facet/geometry.h"
#include "sim/software/facets/facets.h"
#include "sim/software/planes/sheet.h"
#include "sim/software/planes/whole_planes.h"

namespace csgsim::software {

/// Facets as convex regions that whole planes bound, a sheet each. Keeps references.
class FacetSheets {
 public:
  FacetSheets(const Facets& facets, const facet::Geometry& geometry);

  /// What the planes of the facets on its other sides leave of a facet's plane; empty where a facet has no area.
  Region whole(std::uint32_t facet);
  [[nodiscard]] Sheet& of(std::uint32_t facet) { return sheets_[facet]; }
  [[nodiscard]] const Sheet& of(std::uint32_t facet) const { return sheets_[facet]; }
  [[nodiscard]] std::uint32_t plane_of(std::uint32_t facet) const { return facets_.facets[facet].halfspace.plane; }

  /// Whether regions of two facets in different planes have points in common that are on the edges of neither; exact.
  [[nodiscard]] bool cross(std::uint32_t one, const Region& of_one, std::uint32_t other, const Region& of_other) const;

  /// Corners relative to PlaneTable::centre(), counter-clockwise as seen from outside.
  [[nodiscard]] std::vector<glm::dvec3> places(std::uint32_t facet, const Region& region) const;

 private:
  void find_neighbours(std::uint32_t primitive);

  const Facets& facets_;
  WholePlanes planes_;
  std::vector<Sheet> sheets_;
  std::vector<std::vector<facet::Halfspace>> bounds_;  ///< of each facet, by which it ends
};

}  // namespace csgsim::software
