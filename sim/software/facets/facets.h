#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"
#include "host/model/tree.h"

namespace csgsim::software {

/// A face of a primitive, in one of the canonical planes.
struct Facet {
  std::uint32_t primitive = 0;
  facet::Halfspace halfspace;  ///< holds the primitive; its plane is the face's
  std::size_t begin = 0;       ///< of its corners in Facets::corners
  std::size_t end = 0;
};

/// The faces of all primitives: one for each half-space, primitive after primitive, in the order that a primitive has
/// its half-spaces in.
struct Facets {
  std::vector<Facet> facets;
  std::vector<glm::dvec3> corners;         ///< model space, relative to PlaneTable::centre()
  std::vector<std::size_t> of_primitives;  ///< of each primitive its first facet, and of the one after the last

  /// Counter-clockwise as seen from outside. A half-space that meets its primitive in an edge or a corner only has that
  /// one's ends; one that the primitive does not reach by the tolerance of convex::clip() has none.
  [[nodiscard]] std::span<const glm::dvec3> corners_of(std::uint32_t facet) const {
    return std::span(corners).subspan(facets[facet].begin, facets[facet].end - facets[facet].begin);
  }
  /// With an area: those of three corners and more.
  [[nodiscard]] std::size_t polygons() const;
};

/// Throws InputError, naming its place in the file, for a primitive that stays curved: it has no faces.
Facets facets_of(const model::Tree& tree, const facet::Geometry& geometry);

}  // namespace csgsim::software
