#pragma once

#include "host/solids/mesh.h"

namespace csgsim::fuzz {

/// Checks the invariants of a mesh: it is rejected at one of its faces, or it is closed, and its pieces are convex,
/// bounded, and of equal volume in total. See host/solids/limits.h for `tolerance`.
void check_mesh(const solids::Mesh& mesh, double tolerance);

}  // namespace csgsim::fuzz
