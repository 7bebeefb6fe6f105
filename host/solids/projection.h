// OpenSCAD's projection() of solids: shadow and section.
// Used by host/read.
#pragma once

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// The result of OpenSCAD's projection() of solids.
///
/// Corners are rounded to a grid whose step is 2^-36 to 2^-35 of the size of the group of overlapping outlines, and
/// parts thinner than two steps are dropped. Both are independent of z and of solids that are separate along x or y.
struct Projection {
  flat::Area area;
  /// Size of the outline with the coarsest relative rounding, in model units. Both members are set only if a rounding
  /// step exceeds 1e-6 of the outline's size; otherwise they are 0.
  double coarse_size = 0;
  double coarse_step = 0;
};

// Both functions throw WorkError if the work limit is exceeded.

/// The shadow of a tree, projected along z to the x, y plane.
Projection shadow(const model::Tree& tree, const Work& work = {});

/// The intersection of a tree with the x, y plane. All operands include their boundaries, so a face in the plane
/// belongs to unions and intersections, and a subtracted face is removed. Corners within 2^-20 of the plane are treated
/// as in it.
Projection section(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
