#pragma once

#include "host/solids/mesh.h"

namespace csgsim::solids {

/// The hull of the same points in the one form that depends on nothing but the solid: `hull` is a convex surface of
/// triangles with exact signs, of which there are many where more than three of its points are in one plane. Points are
/// those at a corner of the solid, in the order of their coordinates; a face of more than three corners is a fan around
/// the first of them.
Mesh with_sorted_faces(const Mesh& hull);

}  // namespace csgsim::solids
