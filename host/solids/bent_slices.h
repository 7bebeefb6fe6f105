// Linear extrusion with bent sides, slice by slice.
// Used by linear_extrude.cpp.
#pragma once

#include <vector>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "host/solids/extrusion.h"

namespace csgsim::solids {

/// linear_extrude() with bent sides: twisted, or scaled differently in x and y. The height must be above 0. Throws as
/// linear_extrude() does.
std::vector<model::Polyhedron> extrude_bent(const flat::Area& area, const LinearExtrude& extrusion, const Work& work);

}  // namespace csgsim::solids
