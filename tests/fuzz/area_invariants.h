#pragma once

#include "host/flat/area.h"

namespace csgsim::fuzz {

/// Checks the invariants of an area: its corners are finite, and its convex parts are convex and cover an equal area.
void check_area(const flat::Area& area);

}  // namespace csgsim::fuzz
