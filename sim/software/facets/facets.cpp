#include "sim/software/facets/facets.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "host/convex/clip.h"
#include "host/convex/polytope.h"
#include "hw/base/error.h"

namespace csgsim::software {

namespace {

constexpr std::uint32_t no_face = 0xffffffffU;

/// The face of the polytope for each half-space; no_face if there is none. Both have the same order, because clipping
/// appends a face for each half-space.
std::vector<std::uint32_t> faces_of(const convex::Polytope& polytope, const std::vector<facet::Halfspace>& halfspaces) {
  std::vector<std::uint32_t> found(halfspaces.size(), no_face);
  std::uint32_t next = 0;
  for (std::size_t i = 0; i < halfspaces.size() && next < polytope.faces.size(); ++i)
    if (polytope.faces[next].halfspace == halfspaces[i]) found[i] = next++;
  return found;
}

/// Adds the corners of the face or, without a face, the vertices on the half-space's plane.
void add_corners(const convex::Polytope& polytope, std::uint32_t face, const facet::Plane& plane, double near,
                 std::vector<glm::dvec3>& corners) {
  if (face != no_face) {
    for (const std::uint32_t corner : polytope.faces[face].corners) corners.push_back(polytope.vertices[corner]);
    return;
  }
  for (const glm::dvec3& vertex : polytope.vertices) {
    if (std::abs(plane.height(vertex)) <= near) corners.push_back(vertex);
  }
}

}  // namespace

std::size_t Facets::polygon_count() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(facets, [](const Facet& facet) { return facet.end - facet.begin >= 3; }));
}

Facets facets_of(const model::Tree& tree, const facet::Geometry& geometry) {
  Facets facets;
  const double near = convex::tolerance(geometry.planes);
  for (std::uint32_t primitive = 0; primitive < geometry.solids.size(); ++primitive) {
    const facet::Convex& solid = geometry.solids[primitive];
    if (!solid.quadrics.empty()) {
      throw InputError(model::location_text(tree, primitive) +
                       ": this primitive stays curved and has no faces; use --curves facets");
    }
    facets.of_primitives.push_back(facets.facets.size());
    const convex::Polytope polytope = convex::make_polytope(solid, geometry.planes);
    const std::vector<std::uint32_t> faces = faces_of(polytope, solid.halfspaces);
    for (std::size_t i = 0; i < solid.halfspaces.size(); ++i) {
      const facet::Halfspace halfspace = solid.halfspaces[i];
      const std::size_t begin = facets.corners.size();
      add_corners(polytope, faces[i], geometry.planes.planes()[halfspace.plane], near, facets.corners);
      facets.facets.push_back({primitive, halfspace, begin, facets.corners.size()});
    }
  }
  facets.of_primitives.push_back(facets.facets.size());
  return facets;
}

}  // namespace csgsim::software
