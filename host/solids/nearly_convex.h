#pragma once

#include "host/solids/mesh.h"

namespace csgsim::solids {

/// Whether no two faces that join at an edge are dented there by more than 0.1 degrees, all hang together and all edges
/// are between two: what OpenSCAD 2021.01 takes for its convex hull where it meets others.
bool is_nearly_convex(const Mesh& mesh);

}  // namespace csgsim::solids
