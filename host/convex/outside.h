// Difference of a polytope and a convex primitive.
// Used by extent.cpp and pieces.cpp.
#pragma once

#include <vector>

#include "host/convex/polytope.h"

namespace csgsim::convex {

/// The part of a polytope outside a primitive, as convex parts that do not overlap; the polytope itself if the two are
/// disjoint. Cuts are made only by half-spaces that bound the common part. Each cut may lose as much as clip() loses.
/// Throws WorkError if the work limit is exceeded.
std::vector<Polytope> outside(Polytope polytope, const facet::Convex& solid, const facet::PlaneTable& planes,
                              const Work& work = {});

}  // namespace csgsim::convex
