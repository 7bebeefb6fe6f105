// Division of a mesh into convex pieces.
// Used by hull.cpp and host/read.
#pragma once

#include <vector>

#include "host/model/tree.h"
#include "host/solids/limits.h"
#include "host/solids/mesh.h"
#include "hw/base/error.h"

namespace csgsim::solids {

/// Thrown if the surface winds around part of the solid more than once although check.h finds no crossing pair of
/// faces: the faces cross along their edges.
class WindingError : public InputError {
 public:
  using InputError::InputError;
};

/// Divides a solid into convex pieces that do not overlap; pieces that share a plane store it with the same numbers.
/// The mesh must be closed and free of self-intersections (check.h). A convex shell becomes one piece. Shells that face
/// inwards are voids.
///
/// Rounding: faces within the tolerance of one plane are assigned to that plane (regions.h), and a face that is not
/// flat within the tolerance is cut into triangles (flat_faces.h). Solids are divided by these planes only. A corner is
/// treated as on a plane if it is within twice the maximum distance of any corner from its own plane, so that bent
/// faces produce no slivers; thinner parts are lost. If this leaves a hole, or pieces that extend past the surface, as
/// between the turns of a tight spring, each face gets its own plane instead. This gives more pieces, and their total
/// volume is checked against the solid's.
///
/// Throws InputError if there are more pieces than the limits allow or if faces leave a hole, WindingError if the
/// volume of the pieces differs from the volume that the surface winds around, and WorkError if the work limit is
/// exceeded.
std::vector<model::Polyhedron> convex_pieces(const Mesh& mesh, const Limits& limits = {});

/// Like convex_pieces(), for a closed mesh that crosses itself: fills the space where its winding number is not 0,
/// which is the solid that its faces show from outside (enclosed.h). There are more pieces and it takes longer.
std::vector<model::Polyhedron> enclosed_pieces(const Mesh& mesh, const Limits& limits = {});

}  // namespace csgsim::solids
