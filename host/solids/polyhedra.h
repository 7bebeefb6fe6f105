#pragma once

#include "host/convex/polytope.h"
#include "host/model/tree.h"

namespace csgsim::solids {

/// A polytope in model space, with its planes as the table has them.
model::Polyhedron polyhedron_of(const convex::Polytope& polytope, const facet::PlaneTable& planes);

}  // namespace csgsim::solids
