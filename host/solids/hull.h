#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "host/model/tree.h"
#include "host/solids/mesh.h"

namespace csgsim::solids {

/// The convex hull, of triangles, with exact signs: it holds every point. It is the same for the same points in any
/// order. Empty if all points are in one plane.
Mesh hull(std::span<const glm::dvec3> points);

/// The same with triangles in one plane, but for the rounding of doubles, as one face. Nothing if the hull is empty or
/// no thicker than that.
std::optional<model::Polyhedron> hull_piece(std::span<const glm::dvec3> points);

}  // namespace csgsim::solids
