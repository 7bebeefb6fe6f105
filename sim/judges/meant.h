#pragma once

#include "host/facet/faceting.h"
#include "host/model/tree.h"

namespace csgsim::judges {

/// The solid that a primitive stands for in a picture that is faceted so: the primitive itself, or the polyhedron of
/// OpenSCAD's corners for a sphere or cylinder whose own $fn is above 0 and less than Faceting::fewest_round, as a nut
/// has. Where a tolerance or a $fn for all takes the place of its own, it is round as the others.
model::Primitive as_meant(const model::Primitive& primitive, const facet::Faceting& faceting);

/// The least $fn of a model's own that is round if it is faceted so: as_meant asks no more of a faceting.
double fewest_round_of(const facet::Faceting& faceting);

}  // namespace csgsim::judges
