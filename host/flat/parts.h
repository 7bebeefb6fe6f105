#pragma once

#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat {

/// Convex polygons, counter-clockwise, that cover the area exactly and do not overlap: few, but not the fewest. Their
/// corners are the area's, in the same numbers; only where outlines cross, which they should not, there are more. No
/// corner is on the line of its neighbours. Exact in its decisions: a corner that is reflex by the last bit is cut at.
/// What lies within an odd number of the outlines counts as the area.
std::vector<Outline> convex_parts(const Area& area);

}  // namespace csgsim::flat
