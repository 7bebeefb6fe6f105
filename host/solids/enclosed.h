#pragma once

#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "host/solids/limits.h"
#include "host/solids/partition.h"

namespace csgsim::solids {

/// What a closed surface winds around, however often and which way, as convex polytopes that do not overlap:
/// partition() for surfaces that cross themselves. The cell has to hold the surface. Space is divided by planes of its
/// fragments until nothing of the surface is within a cell, so that there are more pieces and it takes longer. Throws
/// InputError if there are more pieces or fragments than the limits allow, and WorkError past the limit on work. Points
/// nearer to a plane than `near`, in model units, are on it.
std::vector<convex::Polytope> enclosed(const Soup& soup, convex::Polytope cell, const facet::PlaneTable& planes,
                                       double near, const Limits& limits);

}  // namespace csgsim::solids
