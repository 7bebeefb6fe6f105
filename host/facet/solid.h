#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/facet/faceting.h"
#include "host/model/tree.h"

namespace csgsim::facet {

/// The half-space normal . p + offset <= 0; the normal points out of the solid and has length 1.
struct Plane {
  glm::dvec3 normal{0, 0, 1};
  double offset = 0;
};

/// A face of a convex solid: its plane, and its corners counter-clockwise or clockwise as seen from outside.
struct Face {
  Plane plane;
  std::vector<std::uint32_t> corners;  ///< indices into Solid::vertices; none if the vertices are only a hull's
};

/// A faceted primitive in model space. Planes are computed from the shape's parameters, not from the rounded vertices.
struct Solid {
  std::vector<glm::dvec3> vertices;  ///< of the solid, or of a hull that holds it
  std::vector<Face> faces;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< edges of such a hull that no face's corners give
};

/// Facets a primitive. The transform must be invertible. Throws InputError if it would take too many facets.
Solid make_solid(const model::Primitive& primitive, const Faceting& faceting = {});

}  // namespace csgsim::facet
