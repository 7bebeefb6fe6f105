#include "sim/software/facets/facets.h"

#include <algorithm>
#include <cmath>

#include "host/convex/clip.h"
#include "host/convex/polytope.h"
#include "hw/base/error.h"

namespace csgsim::software {

namespace {

/// The corners of the face in that plane; of a half-space without a face, the vertices that are on its plane.
void add_corners(const convex::Polytope& polytope, facet::Halfspace halfspace, const facet::PlaneTable& planes,
                 std::vector<glm::dvec3>& corners) {
  const auto face =
      std::ranges::find_if(polytope.faces, [&](const convex::Face& one) { return one.halfspace == halfspace; });
  if (face != polytope.faces.end()) {
    for (const std::uint32_t corner : face->corners) corners.push_back(polytope.vertices[corner]);
    return;
  }
  const facet::Plane& plane = planes.planes()[halfspace.plane];
  for (const glm::dvec3& vertex : polytope.vertices) {
    if (std::abs(plane.height(vertex)) <= convex::tolerance(planes)) corners.push_back(vertex);
  }
}

}  // namespace

std::size_t Facets::polygons() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(facets, [](const Facet& facet) { return facet.end - facet.begin >= 3; }));
}

Facets facets_of(const model::Tree& tree, const facet::Geometry& geometry) {
  Facets facets;
  for (std::uint32_t primitive = 0; primitive < geometry.solids.size(); ++primitive) {
    const facet::Convex& solid = geometry.solids[primitive];
    if (!solid.quadrics.empty()) {
      throw InputError(model::place_of(tree, primitive) +
                       ": this primitive stays curved and has no faces; say --curves facets");
    }
    facets.of_primitives.push_back(facets.facets.size());
    const convex::Polytope polytope = convex::make_polytope(solid, geometry.planes);
    for (const facet::Halfspace halfspace : solid.halfspaces) {
      const std::size_t begin = facets.corners.size();
      add_corners(polytope, halfspace, geometry.planes, facets.corners);
      facets.facets.push_back({primitive, halfspace, begin, facets.corners.size()});
    }
  }
  facets.of_primitives.push_back(facets.facets.size());
  return facets;
}

}  // namespace csgsim::software
