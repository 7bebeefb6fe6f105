#pragma once

#include <span>

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

// What OpenSCAD's projection() makes of solids. Corners are rounded to 2^-29 of the largest coordinate, and what is
// thinner than two of that is left out. Both throw WorkError past the limit on work.

/// The shadow along z of the union of convex pieces on the x, y plane.
flat::Area shadow(std::span<const model::Polyhedron> pieces, const Work& work = {});

/// What of a tree is in the x, y plane: all operands with their boundaries, so that a face that lies in it belongs to
/// what is united and intersected, and a difference loses it. Corners within 2^-20 of the plane are in it.
flat::Area section(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
