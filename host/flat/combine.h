#pragma once

#include <span>

#include "host/flat/area.h"
#include "hw/base/work.h"

namespace csgsim::flat {

// What OpenSCAD makes of 2-D children, in its numbers: one alone stays as it is; of several, all corners come out in
// units of 2^-16. All throw InputError for coordinates that are too large, and WorkError past the
// limit on work.

Area unite(std::span<const Area> areas, const Work& work = {});

/// The first without the others.
Area subtract(std::span<const Area> areas, const Work& work = {});

Area intersect(std::span<const Area> areas, const Work& work = {});

}  // namespace csgsim::flat
