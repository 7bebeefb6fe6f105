// Recognition of convex and nearly convex meshes.
// Used by host/read.
#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/solids/mesh.h"

namespace csgsim::solids {

/// Converts a mesh into one convex solid with the same faces, oriented outwards. The mesh qualifies if exactly two
/// faces join at every edge, each face is flat, and no point is farther outside a face than printed_tolerance allows.
/// Points must be unique and used (join_points() in check.h). The result is empty if the mesh does not qualify or is
/// flat, if a face has no area, or if the cost, points times faces, exceeds 2^30.
std::optional<model::Polyhedron> as_convex_faces(Mesh mesh);

/// Whether every edge is shared by two faces, the mesh has one shell, and no edge is concave by more than 0.1 degrees:
/// OpenSCAD 2021.01 replaces such a mesh by its convex hull where it is combined with others.
bool is_nearly_convex(const Mesh& mesh);

}  // namespace csgsim::solids
