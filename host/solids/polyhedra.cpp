#include "host/solids/polyhedra.h"

#include <glm/geometric.hpp>

#include "host/convex/clip.h"

namespace csgsim::solids {

model::Polyhedron to_polyhedron(const convex::Polytope& polytope, const facet::PlaneTable& planes) {
  model::Polyhedron made;
  for (const glm::dvec3& vertex : polytope.vertices) made.points.push_back(vertex + planes.centre());
  for (const convex::Face& face : polytope.faces) {
    const facet::Plane plane = convex::outward_plane(face.halfspace, planes);
    made.faces.push_back(face.corners);
    made.planes.emplace_back(plane.normal, plane.offset - glm::dot(plane.normal, planes.centre()));
  }
  return made;
}

}  // namespace csgsim::solids
