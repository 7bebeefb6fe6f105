// Convex hulls of 2-D areas.
// Used by host/read and host/solids.
#pragma once

#include <span>

#include "host/flat/area.h"

namespace csgsim::flat {

/// The convex hull of all corners; empty if these are collinear.
Area hull(std::span<const Area> areas);

}  // namespace csgsim::flat
