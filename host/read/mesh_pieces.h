#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/solids/check.h"
#include "host/solids/mesh.h"
#include "host/solids/pieces.h"

namespace csgsim::read {

/// What there is to tell of a mesh that is drawn, and the face (its number in the file) to point at.
struct Remark {
  std::uint32_t face = 0;
  std::string what;
};

/// The convex pieces of a mesh, or what keeps it from being a solid.
struct MeshPieces {
  std::vector<model::Polyhedron> pieces;
  std::optional<solids::Defect> defect{};
  std::vector<Remark> remarks{};
};

/// As OpenSCAD 2021.01 draws the mesh: faces that are not flat are cut into its triangles, what is nearly convex is its
/// convex hull where it meets others, and a mesh whose faces cross is what they wind around. `tolerance`: see
/// solids/limits.h. Throws InputError past the limits on pieces, and WorkError past that on work.
MeshPieces pieces_of(const solids::Mesh& mesh, double tolerance, const solids::MeshPlacement& mesh_placement,
                     const Work& work);

}  // namespace csgsim::read
