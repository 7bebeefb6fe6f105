// Division of a profile into convex parts that suit rotation about the y axis.
// Used by rotate_extrude.cpp.
#pragma once

#include <vector>

#include "host/flat/area.h"

namespace csgsim::solids {

/// Divides an area to the right of the y axis into convex, counter-clockwise polygons that cover it without overlap.
/// The cuts are horizontal, through the area's corners, and only where the union of the parts above and below is not
/// convex: a part along the axis can then often be rotated about it as one piece. New corners lie on the area's sides,
/// apart from rounding.
std::vector<flat::Outline> axis_parts(const flat::Area& area);

}  // namespace csgsim::solids
