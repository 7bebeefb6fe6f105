#pragma once

#include "host/flat/area.h"
#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

/// The result of OpenSCAD's projection() of solids.
///
/// Corners are rounded to 2^-36 to 2^-35 of the size of the outlines that reach across each other, and what is thinner
/// than two of that is left out. Neither depends on z, nor on solids that are apart from these along x or y.
struct Projection {
  flat::Area area;
  /// The size of the outline that is rounded most for its size, and the step that it is rounded to, in model units: the
  /// step is above 1e-6 of the size. 0 if there is none.
  double coarse_size = 0;
  double coarse_step = 0;
};

// Both throw WorkError past the limit on work.

/// The shadow of a tree along z on the x, y plane.
Projection shadow(const model::Tree& tree, const Work& work = {});

/// What of a tree is in the x, y plane: all operands with their boundaries, so that a face that lies in it belongs to
/// what is united and intersected, and a difference loses it. Corners within 2^-20 of the plane are in it.
Projection section(const model::Tree& tree, const Work& work = {});

}  // namespace csgsim::solids
