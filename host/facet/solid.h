// Primitives in model space, faceted or curved.
// Used throughout host/facet and by host/convex, host/solids and sim/software.
#pragma once

#include <array>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "host/facet/faceting.h"
#include "host/facet/quadric_table.h"
#include "host/model/tree.h"

namespace csgsim::facet {

/// The half-space normal . p + offset <= 0; the normal points out of the solid and has length 1.
struct Plane {
  glm::dvec3 normal{0, 0, 1};
  double offset = 0;

  /// Signed distance of a point from the plane: positive in front, negative behind.
  [[nodiscard]] double height(const glm::dvec3& point) const { return glm::dot(normal, point) + offset; }
};

/// A face of a convex solid: its plane, and its corners in order around it, in either direction.
struct Face {
  Plane plane;
  std::vector<std::uint32_t> corners;  ///< indices into Solid::vertices; empty if the vertices are those of a hull only
};

/// The curved surface of a solid, in model space.
struct CurvedSurface {
  Quadric quadric;       ///< only kind, origin and to_unit are set
  glm::dvec3 inward{0};  ///< cones: a direction from the apex into the solid's nappe
  glm::dvec3 low{1};     ///< bounding box of the solid
  glm::dvec3 high{0};
};

/// A primitive in model space, faceted or curved. Planes are computed from the shape's parameters, not from the rounded
/// vertices.
struct Solid {
  std::vector<glm::dvec3> vertices;  ///< vertices of the solid, or of a hull that contains it
  std::vector<Face> faces;
  std::vector<std::array<std::uint32_t, 2>> edges;  ///< edges of the hull that are not edges of a face
  std::optional<CurvedSurface> curved;
};

/// Facets a primitive. Its transform must be invertible. Throws InputError if too many facets would be needed.
Solid make_solid(const model::Primitive& primitive, const Faceting& faceting = {});

}  // namespace csgsim::facet
