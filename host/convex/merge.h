#pragma once

#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "hw/base/work.h"

namespace csgsim::convex {

/// Joins polytopes that do not overlap, two at a time, for as long as two of them lie on either side of a plane that
/// both have a face on, and are convex together within the tolerance of clip(). Greedy: not the fewest that there are.
/// Throws WorkError past the limit on work.
void merge(std::vector<Polytope>& polytopes, const facet::PlaneTable& planes, const Work& work = {});

}  // namespace csgsim::convex
