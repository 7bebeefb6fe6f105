#pragma once

#include "host/read/arguments.h"
#include "host/read/operands.h"

namespace csgsim::read {

/// A `polyhedron` node: a convex one as it is, but points that no face uses are left out, equal points are one, and
/// faces run counter-clockwise seen from outside; any other in convex pieces (host/solids/pieces.h). Nothing if it has
/// no faces, no volume or a point that is not finite. Throws InputError at the face that keeps it from bounding a
/// solid.
Maker read_polyhedron(const Arguments& arguments);

}  // namespace csgsim::read
