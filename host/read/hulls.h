#pragma once

#include "host/read/arguments.h"
#include "host/read/operands.h"

namespace csgsim::read {

// Nodes that make a shape of what their children are together.

Maker read_hull(const Arguments& arguments);
Maker read_minkowski(const Arguments& arguments);
Maker read_resize(const Arguments& arguments);
Maker read_projection(const Arguments& arguments);

}  // namespace csgsim::read
