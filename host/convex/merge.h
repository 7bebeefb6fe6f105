// Merging of adjacent convex polytopes.
// Used by pieces.cpp and host/solids.
#pragma once

#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "hw/base/work.h"

namespace csgsim::convex {

/// Merges pairs of polytopes as long as two of them lie on opposite sides of a plane that holds a face of both, and are
/// convex together within the tolerance of clip(). The polytopes must not overlap. Greedy, so the result is not
/// minimal. Throws WorkError past the limit on work.
void merge(std::vector<Polytope>& polytopes, const facet::PlaneTable& planes, const Work& work = {});

}  // namespace csgsim::convex
