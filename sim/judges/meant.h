// Distinguishes polygons that a model means from round solids that are faceted.
// Used by the analytic truth and sim/studies/accuracy.
#pragma once

#include "host/facet/faceting.h"
#include "host/model/tree.h"

namespace csgsim::judges {

/// The solid that a primitive means in a picture with that faceting: the primitive itself or, for a sphere or cylinder
/// whose own $fn is above 0 and below Faceting::min_round_sides (such as a nut), the polyhedron with OpenSCAD's
/// corners. If a tolerance or a global $fn replaces its own, it is round like the others.
model::Primitive as_meant(const model::Primitive& primitive, const facet::Faceting& faceting);

/// Minimum $fn of a model that means a round solid with that faceting. as_meant depends on nothing else of the
/// faceting.
double min_round_fragments(const facet::Faceting& faceting);

}  // namespace csgsim::judges
