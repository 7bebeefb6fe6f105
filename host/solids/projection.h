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
/// parts thinner than two steps are dropped. Neither depends on z or on solids that are separate along x or y.
struct Projection {
  flat::Area area;
  /// The size of the outline with the coarsest relative rounding, and its rounding step, both in model units. Set only
  /// if a step exceeds 1e-6 of the outline's size; otherwise 0.
  double coarse_size = 0;
  double coarse_step = 0;
};

// Both functions throw WorkError past the limit on work.

/// The shadow of a tree, projected along z to the x, y plane.
Projection shadow(const model::Tree& tree, const Work& work = {});

/// The intersection of a tree with the x, y plane. All operands include their boundaries, so a face in the plane
/// belongs to unions and intersections, and a subtracted one is removed. Corners within 2^-20 of the plane count as in
/// it.
Projection section(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
