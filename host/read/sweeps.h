#pragma once

#include "host/read/arguments.h"
#include "host/read/operands.h"

namespace csgsim::read {

// Nodes that sweep an area.

Maker read_linear_extrude(const Arguments& arguments);
Maker read_rotate_extrude(const Arguments& arguments);

}  // namespace csgsim::read
