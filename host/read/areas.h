#pragma once

#include "host/read/arguments.h"
#include "host/read/operands.h"

namespace csgsim::read {

// Nodes that are areas, and that make areas of areas.

Maker read_square(const Arguments& arguments);
Maker read_circle(const Arguments& arguments);
Maker read_polygon(const Arguments& arguments);
Maker read_text(const Arguments& arguments);
Maker read_offset(const Arguments& arguments);

}  // namespace csgsim::read
