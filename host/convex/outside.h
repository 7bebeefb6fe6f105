#pragma once

#include <vector>

#include "host/convex/polytope.h"

namespace csgsim::convex {

/// What of a polytope is outside of a primitive, in convex parts that do not overlap; the polytope itself if they have
/// nothing in common. Only half-spaces that the common part has a face on take part. Each cut may lose what clip()
/// loses. Throws WorkError past the limit on work.
std::vector<Polytope> outside(Polytope polytope, const facet::Convex& solid, const facet::PlaneTable& planes,
                              const Work& work = {});

}  // namespace csgsim::convex
