// Division of 2-D areas into convex polygons.
// Used by host/solids.
#pragma once

#include <vector>

#include "host/flat/area.h"

namespace csgsim::flat {

/// Divides an area into counter-clockwise convex polygons that cover it exactly without overlap. Their number is small,
/// but not minimal. Their corners are the area's own, unless outlines cross, which is not allowed in an Area. No corner
/// is collinear with its neighbours. All decisions are exact: a corner that is reflex only in the last bit still causes
/// a cut. The area consists of the points inside an odd number of outlines.
std::vector<Outline> convex_parts(const Area& area);

}  // namespace csgsim::flat
