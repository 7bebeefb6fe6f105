#pragma once

#include <vector>

#include "host/flat/area.h"

namespace csgsim::solids {

/// An area to the right of the y axis in convex polygons, counter-clockwise, that cover it and do not overlap, made so
/// that few of them turn about the axis as one: horizontal cuts through the area's corners, where what is above is not
/// convex with what is below. New corners are on the area's sides, to rounding.
std::vector<flat::Outline> axis_parts(const flat::Area& area);

}  // namespace csgsim::solids
