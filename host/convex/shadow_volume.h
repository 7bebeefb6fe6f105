#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "host/facet/solid.h"

namespace csgsim::convex {

/// A light in homogeneous coordinates, model space.
struct Light {
  glm::dvec4 place{0, 0, 1, 0};  ///< (x, y, z, 0): far away in that direction; (x, y, z, 1): at that point
};

/// Where a polytope takes the light away (F. Crow, "Shadow algorithms for computer graphics", SIGGRAPH 1977): the
/// points from which the open segment to the light meets it; its own points are among them. The volume is the
/// intersection of the half-spaces of all three lists, none of which is redundant.
///
/// A face whose plane the light is on, within facet::coincidence_tolerance of the model's diagonal or of its own
/// distance, does not face it.
struct ShadowVolume {
  std::vector<facet::Halfspace> facing;   ///< of the faces that face the light
  std::vector<facet::Halfspace> edge_on;  ///< of faces whose planes the light is on and that bound the volume
  std::vector<facet::Plane> silhouette;   ///< through silhouette edges and the light; as in PlaneTable::planes()

  /// The volume is their hull, and from there whatever sum of `directions` leads on: multiples of at least 0.
  std::vector<glm::dvec3> corners;     ///< model space
  std::vector<glm::dvec3> directions;  ///< of any length

  /// The light is inside of the polytope: everything is in the shadow.
  [[nodiscard]] bool everything() const { return facing.empty() && edge_on.empty(); }
};

/// A silhouette plane is the combination of its edge's two face planes, with weights of at least 0, that the light is
/// on: it takes nothing from the vertices, so that pieces which share both planes share the silhouette plane exactly.
/// With the light on a face of the polytope the volume is bounded by the faces that it is on alone.
ShadowVolume shadow_volume(const Polytope& polytope, const Light& light, const facet::PlaneTable& planes);

}  // namespace csgsim::convex
