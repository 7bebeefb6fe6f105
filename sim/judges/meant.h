// Distinguishes polygons that a model intends from round solids that are faceted.
// Used by the analytic truth and sim/studies/accuracy.
#pragma once

#include "host/facet/faceting.h"
#include "host/model/tree.h"

namespace csgsim::judges {

/// The solid that the model intends, for a picture with that faceting: the primitive itself or, for a sphere or
/// cylinder whose own $fn is above 0 and below Faceting::min_round_sides (such as a nut), the polyhedron with
/// OpenSCAD's corners. If the faceting replaces the primitive's $fn by a tolerance or a global $fn, the solid is round.
model::Primitive intended_solid(const model::Primitive& primitive, const facet::Faceting& faceting);

/// Minimum $fn of a primitive that is intended as round with that faceting. intended_solid depends on nothing else of
/// the faceting.
double min_round_fragments(const facet::Faceting& faceting);

}  // namespace csgsim::judges
