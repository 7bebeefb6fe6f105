#pragma once

#include <optional>
#include <vector>

#include "host/solids/check.h"
#include "host/solids/mesh.h"
#include "host/solids/pieces.h"

namespace csgsim::read {

/// The convex pieces of a mesh, or what keeps it from being a solid.
struct MeshPieces {
  std::vector<model::Polyhedron> pieces;
  std::optional<solids::Defect> defect;
};

/// `tolerance`: see solids/limits.h. Throws InputError past the limits on pieces.
MeshPieces pieces_of(const solids::Mesh& mesh, double tolerance);

}  // namespace csgsim::read
