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
/// on the order of the points. Empty if all points are in one plane. Throws WorkError if the work limit is exceeded.
Mesh hull(std::span<const glm::dvec3> points, const Work& work = {});

/// The convex hull, in which triangles that are coplanar, apart from rounding, are joined into one face. Empty if the
/// hull is empty or no thicker than rounding.
std::optional<model::Polyhedron> hull_piece(std::span<const glm::dvec3> points, const Work& work = {});

}  // namespace csgsim::solids
