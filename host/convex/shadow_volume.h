// Shadow volumes of polytopes.
// Used by host/effects.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "host/facet/solid.h"

namespace csgsim::convex {

/// A light in homogeneous coordinates of model space.
struct Light {
  /// (x, y, z, 0): infinitely far in the direction (x, y, z); (x, y, z, 1): at the point (x, y, z).
  glm::dvec4 place{0, 0, 1, 0};
};

/// The region shadowed by a polytope (F. Crow, "Shadow algorithms for computer graphics", SIGGRAPH 1977): the points
/// whose open segment to the light intersects the polytope, including the polytope's own points. It is the intersection
/// of the half-spaces in all three lists; none of them is redundant.
///
/// A face does not face the light if the light is on its plane, within facet::coincidence_tolerance times the model's
/// diagonal or the light's distance.
struct ShadowVolume {
  std::vector<facet::Halfspace> facing;   ///< half-spaces of the faces that face the light
  std::vector<facet::Halfspace> edge_on;  ///< half-spaces of bounding faces whose planes contain the light
  /// Planes through silhouette edges and the light, in the form of PlaneTable::planes().
  std::vector<facet::Plane> silhouette;

  /// The volume is the convex hull of the corners, extended by all nonnegative combinations of the directions.
  std::vector<glm::dvec3> corners;     ///< model space
  std::vector<glm::dvec3> directions;  ///< arbitrary lengths

  /// Whether the light is inside the polytope, so that everything is in the shadow.
  [[nodiscard]] bool everything() const { return facing.empty() && edge_on.empty(); }
};

/// Computes the shadow volume. A silhouette plane is the combination, with nonnegative weights, of the planes of its
/// edge's two faces that contains the light. It does not depend on the vertices, so pieces that share both planes have
/// exactly the same silhouette plane. If the light is on a face of the polytope, only the faces that contain the light
/// bound the volume.
ShadowVolume shadow_volume(const Polytope& polytope, const Light& light, const facet::PlaneTable& planes);

}  // namespace csgsim::convex
