// Space enclosed by a self-intersecting surface, as convex polytopes.
// Used by bent_slices.cpp and pieces.cpp.
#pragma once

#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "host/solids/limits.h"
#include "host/solids/partition.h"

namespace csgsim::solids {

/// Convex polytopes, without overlap, that fill the space where the winding number of a closed surface is not 0. Unlike
/// partition(), this works for surfaces that cross themselves. The cell must contain the surface. Space is divided by
/// planes of the fragments until no part of the surface is inside a cell, so there are more pieces and it takes longer.
/// Points closer to a plane than `near`, in model units, are treated as on it. Throws InputError if there are more
/// pieces or fragments than the limits allow, and WorkError if the work limit is exceeded.
std::vector<convex::Polytope> enclosed(const Soup& soup, convex::Polytope cell, const facet::PlaneTable& planes,
                                       double near, const Limits& limits);

}  // namespace csgsim::solids
