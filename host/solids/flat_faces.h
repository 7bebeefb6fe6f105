#pragma once

#include <glm/vec3.hpp>

#include "host/solids/mesh.h"

namespace csgsim::solids {

/// Newell's vector: normal to the face, as long as twice its area.
glm::dvec3 area_vector(const Mesh& mesh, const std::vector<std::uint32_t>& face);

/// The farthest that a corner of a face is off the plane through the mean of its corners, across that vector.
double off_plane(const Mesh& mesh, const std::vector<std::uint32_t>& face);

/// The largest magnitude of a coordinate.
double largest_coordinate(const Mesh& mesh);

/// A face in parts that are flat and convex: itself, if it is. A face with a corner farther off its plane than the
/// tolerance, in model units, or with a reflex corner is cut into triangles, ear by ear: the first ear from the first
/// corner on. One that crosses itself so that its area is 0 is cut into triangles too.
std::vector<std::vector<std::uint32_t>> flat_convex_parts(const Mesh& mesh, const std::vector<std::uint32_t>& face,
                                                          double tolerance);

/// The same surface with all faces in such parts.
Mesh with_flat_convex_faces(const Mesh& mesh, double tolerance);

}  // namespace csgsim::solids
