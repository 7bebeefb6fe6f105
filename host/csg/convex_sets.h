// Sets of primitives that are drawn as one convex solid.
// Used by host/emit and sim/story.
#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/positive_tree.h"

namespace csgsim::csg {

/// Primitives that are drawn as one convex solid (thesis 7.3.2): the intersection of all their half-spaces.
using ConvexSet = std::vector<std::uint32_t>;

/// The sets that contain every primitive of the tree once, in tree order. If `joined`, consecutive primitives that are
/// not complemented and are only joined by intersections share a set; all others are alone. Joining complemented ones,
/// or primitives with others between them, would change the owner of coincident surfaces.
std::vector<ConvexSet> convex_sets(const PositiveTree& tree, bool joined);

}  // namespace csgsim::csg
