#include "host/read/mesh_pieces.h"

#include <utility>

namespace csgsim::read {

MeshPieces pieces_of(const solids::Mesh& mesh, double tolerance) {
  solids::Checked checked = solids::check(mesh, tolerance);
  if (checked.defect) return {{}, std::move(checked.defect)};
  solids::Limits limits;
  limits.tolerance = tolerance;
  return {solids::convex_pieces(checked.mesh, limits), std::nullopt};
}

}  // namespace csgsim::read
