#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/solids/mesh.h"

namespace csgsim::solids {

/// A mesh as one convex solid with the faces that it has, turned outwards, if it is one by their look: two faces join
/// at every edge, each is flat, and no point is farther outside of one than printed_tolerance allows. Points have to be
/// each once, and used (join_points in check.h). Nothing otherwise, if it is flat or a face has no area, and if points
/// times faces, which is what this takes, are more than 2^30.
std::optional<model::Polyhedron> as_convex_faces(Mesh mesh);

/// Whether no edge is dented by more than 0.1 degrees, each edge is between two faces, and all faces hang together:
/// OpenSCAD 2021.01 takes such a mesh for its convex hull where it meets others.
bool is_nearly_convex(const Mesh& mesh);

}  // namespace csgsim::solids
