// Conversion of meshes to convex pieces, with notes on repairs.
// Used by imports.cpp, polyhedron.cpp and host/commands.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "host/solids/check.h"
#include "host/solids/mesh.h"
#include "host/solids/pieces.h"

namespace csgsim::read {

/// A remark about a mesh that was drawn, and the file number of the face to report.
struct Remark {
  std::uint32_t face = 0;
  std::string what;
};

/// The convex pieces of a mesh, or the reason why the mesh is not a solid.
struct MeshPieces {
  std::vector<model::Polyhedron> pieces;
  std::optional<solids::Defect> defect{};
  std::vector<Remark> remarks{};
};

/// Divides a mesh as OpenSCAD 2021.01 draws it: bent faces are cut into OpenSCAD's triangles, a nearly convex mesh is
/// replaced by its convex hull where it is combined with others, and a mesh whose faces cross becomes the space that
/// they enclose. `tolerance` is described in solids/limits.h. Throws InputError for too many pieces, and WorkError if
/// the work limit is exceeded.
MeshPieces pieces_of(const solids::Mesh& mesh, double tolerance, const solids::MeshPlacement& mesh_placement,
                     const Work& work);

}  // namespace csgsim::read
