#pragma once

#include <span>

#include "host/flat/area.h"

namespace csgsim::flat {

// What OpenSCAD makes of 2-D children, in its numbers: one alone stays as it is; of several, all corners come out in
// units of 2^-16. All throw InputError for coordinates that are too large.

Area unite(std::span<const Area> areas);

/// The first without the others.
Area subtract(std::span<const Area> areas);

Area intersect(std::span<const Area> areas);

}  // namespace csgsim::flat
