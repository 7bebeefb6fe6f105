#pragma once

#include <span>

#include "host/convex/polytope.h"
#include "host/solids/partition.h"

namespace csgsim::solids {

/// Whether a surface covers those faces of a piece that lie in none of the walls. Their areas are compared as a whole,
/// since planes that are hardly tilted to each other share what they cover by chance; what is missing may be slivers
/// that are no wider than `near`, in model units, a few along each side. A piece that is not covered has grown past the
/// surface, where a part of that was lost.
bool is_covered(const convex::Polytope& piece, std::span<const facet::Halfspace> walls, const Soup& surface,
                double near);

}  // namespace csgsim::solids
