// Minkowski sums of 2-D areas.
// Used by host/read.
#pragma once

#include <span>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

/// OpenSCAD's Minkowski sum of the first area and the other non-empty areas, in units of 2^-16. A single area stays
/// unchanged. Empty if the first area is empty or all others are. Throws InputError for coordinates that are too large
/// or too many corners, and WorkError if the work limit is exceeded.
Area minkowski(std::span<const Area> areas, const Work& work = {});

}  // namespace csgsim::flat
