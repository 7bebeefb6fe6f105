#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/positive_tree.h"

namespace csgsim::csg {

/// Primitives that are drawn as one convex solid (thesis 7.3.2): the intersection of all their half-spaces.
using ConvexSet = std::vector<std::uint32_t>;

/// Every primitive of the tree in one set, in tree order. Those that follow one another, that intersections alone join
/// and that are not complemented share a set if `joined`; every other one is on its own. Where surfaces coincide the
/// owner would depend on joining complemented ones, or some with others between them.
std::vector<ConvexSet> convex_sets(const PositiveTree& tree, bool joined);

}  // namespace csgsim::csg
