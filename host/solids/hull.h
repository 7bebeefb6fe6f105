// Convex hulls of points, computed with exact predicates.
// Used by minkowski.cpp and host/read.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "host/model/tree.h"
#include "host/solids/mesh.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// The convex hull as triangles, computed with exact predicates, so it contains every point. The result does not depend
/// on the order of the points. Empty if all points are in one plane. Throws WorkError past the limit on work.
Mesh hull(std::span<const glm::dvec3> points, const Work& work = {});

/// The same, with triangles that are coplanar, to rounding, joined into one face. Nothing if the hull is empty or no
/// thicker than rounding.
std::optional<model::Polyhedron> hull_piece(std::span<const glm::dvec3> points, const Work& work = {});

}  // namespace csgsim::solids
