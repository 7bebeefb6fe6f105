// OpenSCAD's Booleans of 2-D areas.
// Used by host/read.
#pragma once

#include <span>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

// OpenSCAD's operations on 2-D children. A single area stays unchanged; if there are several, all corners are rounded
// to units of 2^-16. All functions throw InputError for coordinates that are too large, and WorkError if the work limit
// is exceeded.

Area unite(std::span<const Area> areas, const Work& work = {});

/// The first area minus the others.
Area subtract(std::span<const Area> areas, const Work& work = {});

Area intersect(std::span<const Area> areas, const Work& work = {});

}  // namespace csgsim::flat
