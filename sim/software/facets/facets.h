// Facets of primitives in space.
// Used by sim/studies.
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

/// A face of a primitive in one of the canonical planes.
struct Facet {
  std::uint32_t primitive = 0;
  facet::Halfspace halfspace;  ///< contains the primitive; its plane is that of the face
  std::size_t begin = 0;       ///< range of its corners in Facets::corners
  std::size_t end = 0;
};

/// The faces of all primitives: one per half-space, in the order of primitives and of their half-spaces.
struct Facets {
  std::vector<Facet> facets;
  std::vector<glm::dvec3> corners;         ///< in model space, relative to PlaneTable::centre()
  std::vector<std::size_t> of_primitives;  ///< index of each primitive's first facet, and the end

  /// Corners in counter-clockwise order as seen from outside. A half-space that touches its primitive only in an edge
  /// or corner has the ends of that edge, or that corner; one that is farther from the primitive than the tolerance of
  /// convex::clip() has none.
  [[nodiscard]] std::span<const glm::dvec3> corners_of(std::uint32_t facet) const {
    return std::span(corners).subspan(facets[facet].begin, facets[facet].end - facets[facet].begin);
  }
  /// Number of facets with an area, i.e. at least three corners.
  [[nodiscard]] std::size_t polygon_count() const;
};

/// The facets of all primitives. Throws InputError, with the primitive's place in the file, for a primitive that stays
/// curved and thus has no facets.
Facets facets_of(const model::Tree& tree, const facet::Geometry& geometry);

}  // namespace csgsim::software
