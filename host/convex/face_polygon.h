#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "host/facet/geometry.h"
#include "host/facet/planes.h"

namespace csgsim::convex {

/// Two directions in a plane, of length 1 and across each other.
std::array<glm::dvec3, 2> axes_in(const glm::dvec3& normal);

/// What of a convex polygon is behind a plane; corners within `near` of it stay where they are. Nothing where none is
/// farther behind it.
std::vector<glm::dvec3> clipped(std::vector<glm::dvec3> corners, const facet::Plane& plane, double near);

/// The corners of the face that a primitive has in a plane, in turn around it, relative to PlaneTable::centre(): what
/// its other half-spaces leave of that plane, which takes a step for each of them, where make_polytope() makes all
/// faces. None if the primitive has only an edge or a corner there, or a sliver no wider than the tolerance of
/// clip(), or if the half-spaces leave the face without an end.
std::vector<glm::dvec3> face_polygon(const facet::Convex& solid, std::uint32_t plane, const facet::PlaneTable& planes);

}  // namespace csgsim::convex
