#pragma once

#include "host/flat/area.h"

namespace csgsim::fuzz {

/// What holds of every area that is read: its corners are finite, and its convex parts are convex and cover as much.
void check_area(const flat::Area& area);

}  // namespace csgsim::fuzz
