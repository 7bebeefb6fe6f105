#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "host/model/tree.h"
#include "host/solids/mesh.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// The convex hull, of triangles, with exact signs: it holds every point. It is the same for the same points in any
/// order. Empty if all points are in one plane. Throws WorkError past the limit on work.
Mesh hull(std::span<const glm::dvec3> points, const Work& work = {});

/// The same, with triangles in one plane, give or take rounding, joined to one face. Nothing if the hull is empty or
/// no thicker than that.
std::optional<model::Polyhedron> hull_piece(std::span<const glm::dvec3> points, const Work& work = {});

}  // namespace csgsim::solids
