// Merging of adjacent convex polytopes.
// Used by pieces.cpp and host/solids.
#pragma once

#include <vector>

#include "host/convex/polytope.h"
#include "host/facet/planes.h"
#include "hw/base/work.h"

namespace csgsim::convex {

/// Merges pairs of polytopes as long as some two lie on opposite sides of a plane that contains a face of both, and
/// their union is convex within the tolerance of clip(). The polytopes must not overlap. The algorithm is greedy, so
/// the result is not minimal. Throws WorkError if the work limit is exceeded.
void merge(std::vector<Polytope>& polytopes, const facet::PlaneTable& planes, const Work& work = {});

}  // namespace csgsim::convex
