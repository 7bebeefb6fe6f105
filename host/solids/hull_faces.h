// Canonical form of a convex hull.
// Used by hull.cpp.
#pragma once

#include "host/solids/mesh.h"

namespace csgsim::solids {

/// A canonical form of a convex hull, which depends only on the solid. `hull` is a convex surface of triangles with
/// exact orientation; its triangulation is not unique if more than three points are in one plane. The result has only
/// the points at corners of the solid, sorted by their coordinates; a face with more than three corners becomes a fan
/// of triangles around its first corner.
Mesh canonical_hull(const Mesh& hull);

}  // namespace csgsim::solids
