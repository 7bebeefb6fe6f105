#pragma once

#include "host/solids/mesh.h"

namespace csgsim::fuzz {

/// Holds a mesh against what is promised of it: it is refused at one of its faces, or it is closed, and its pieces are
/// convex, bounded, and as large as it. `tolerance`: see host/solids/limits.h.
void check_mesh(const solids::Mesh& mesh, double tolerance);

}  // namespace csgsim::fuzz
