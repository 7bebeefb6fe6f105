// Conversion of polytopes to model space.
// Used by bent_slices.cpp, evaluate.cpp and pieces.cpp.
#pragma once

#include "host/convex/polytope.h"
#include "host/model/tree.h"

namespace csgsim::solids {

/// Converts a polytope to model space. Its planes are stored with the numbers of the table.
model::Polyhedron to_polyhedron(const convex::Polytope& polytope, const facet::PlaneTable& planes);

}  // namespace csgsim::solids
