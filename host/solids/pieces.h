#pragma once

#include <vector>

#include "host/model/tree.h"
#include "host/solids/limits.h"
#include "host/solids/mesh.h"
#include "hw/base/error.h"

namespace csgsim::solids {

/// The surface winds around a part of its solid more than once, though check.h finds no two faces that cross: they
/// cross along their edges.
class WindingError : public InputError {
 public:
  using InputError::InputError;
};

/// A solid as convex pieces that do not overlap, and say planes that they share in the same numbers. The mesh has to be
/// closed and may not meet itself: check.h. A convex shell is one piece. Shells that face inwards are
/// voids.
///
/// Rounding: faces within the tolerance of one plane are in it (regions.h), and a flat face that is not is cut into
/// triangles (flat_faces.h). Solids are divided by these planes alone. Corners are on planes that they are off by no
/// more than twice the farthest that one is off its own: so bent faces make no slivers, and what is thinner is lost.
/// Where that leaves a hole, or pieces that grow past the surface, as beside the turns of a tight spring, each face is
/// in its own plane instead, in more pieces, of which the volume is held against the solid's.
///
/// Throws InputError if the pieces are more than the limits allow, or if faces leave a hole, WindingError if the pieces
/// are not as large as what the surface winds around, and WorkError past the limit on work.
std::vector<model::Polyhedron> convex_pieces(const Mesh& mesh, const Limits& limits = {});

/// The same of a closed mesh that crosses itself: all that it winds around, however often and which way, which is what
/// is seen of its faces from outside (enclosed.h). There are more pieces and it takes longer.
std::vector<model::Polyhedron> enclosed_pieces(const Mesh& mesh, const Limits& limits = {});

}  // namespace csgsim::solids
