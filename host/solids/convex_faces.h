#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/solids/mesh.h"

namespace csgsim::solids {

/// A mesh as one convex solid with the faces that it has, turned outwards, if it is one by their look: two faces join
/// at every edge, each is flat, and no point is outside of one, but for what printed_tolerance allows. Points are each
/// once, and used (join_points in check.h). Nothing otherwise, if it is flat or a face has no area, and if points times
/// faces, which is what this takes, are more than 2^30.
std::optional<model::Polyhedron> as_convex_faces(Mesh mesh);

/// Whether no two faces that join at an edge are dented there by more than 0.1 degrees, all hang together and all edges
/// are between two: what OpenSCAD 2021.01 takes for its convex hull where it meets others.
bool is_nearly_convex(const Mesh& mesh);

}  // namespace csgsim::solids
