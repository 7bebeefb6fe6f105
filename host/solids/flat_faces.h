// Face normals, planarity, and division of faces into flat convex parts.
// Used throughout host/solids.
#pragma once

#include <glm/vec3.hpp>

#include "host/solids/mesh.h"

namespace csgsim::solids {

/// Newell's vector: normal to the face, with twice its area as length.
glm::dvec3 area_vector(const Mesh& mesh, const std::vector<std::uint32_t>& face);

/// Maximum distance of a face's corners from the plane through their mean that is normal to area_vector().
double max_plane_distance(const Mesh& mesh, const std::vector<std::uint32_t>& face);

/// The largest magnitude of any coordinate.
double largest_coordinate(const Mesh& mesh);

/// Divides a face into flat convex parts; a flat convex face is returned unchanged. A face with a reflex corner, or
/// with a corner farther off its plane than the tolerance, in model units, is cut into triangles by ear clipping that
/// starts at the first corner. A face that crosses itself and has a total area of 0 is also cut into triangles.
std::vector<std::vector<std::uint32_t>> flat_convex_parts(const Mesh& mesh, const std::vector<std::uint32_t>& face,
                                                          double tolerance);

/// The same surface with each face divided by flat_convex_parts().
Mesh with_flat_convex_faces(const Mesh& mesh, double tolerance);

}  // namespace csgsim::solids
