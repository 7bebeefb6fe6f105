#pragma once

#include <span>

#include "host/flat/area.h"

namespace csgsim::flat {

/// The smallest convex polygon that holds all corners; empty if they are on a line.
Area hull(std::span<const Area> areas);

}  // namespace csgsim::flat
