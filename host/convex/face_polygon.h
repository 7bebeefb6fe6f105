// Polygon of one face of a primitive.
// Used by near_faces.cpp and host/solids.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"

namespace csgsim::convex {

/// Two orthogonal unit vectors in a plane.
std::array<glm::dvec3, 2> plane_axes(const glm::dvec3& normal);

/// The part of a convex polygon behind a plane. Corners within `tolerance` of the plane do not move. Empty if no corner
/// is more than `tolerance` behind the plane.
std::vector<glm::dvec3> clipped(std::vector<glm::dvec3> corners, const facet::Plane& plane, double tolerance);

/// The corners of a primitive's face in a plane, in order around it, relative to PlaneTable::centre(). The face is the
/// part of the plane inside the other half-spaces, so its cost is one step per half-space, while make_polytope()
/// computes all faces. Empty if the primitive has only an edge or a corner in the plane, if the face is no wider than
/// the tolerance of clip(), or if the half-spaces leave it unbounded.
std::vector<glm::dvec3> face_polygon(const facet::Convex& solid, std::uint32_t plane, const facet::PlaneTable& planes);

}  // namespace csgsim::convex
