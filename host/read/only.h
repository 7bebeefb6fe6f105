#pragma once

#include "host/read/operands.h"

namespace csgsim::read {

/// The union of children that are areas.
flat::Area only_area(const Operands& operands);

/// Whether that union is an area, if an empty one. As in OpenSCAD a single child that is empty is nothing at all.
bool has_area(const Operands& operands);

/// The union of children that are solids, of no nodes if there are none.
model::Tree only_solid(Operands operands);

}  // namespace csgsim::read
