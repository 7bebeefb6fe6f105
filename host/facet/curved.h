#pragma once

#include "host/facet/faceting.h"
#include "host/facet/quadrics.h"
#include "host/facet/solid.h"
#include "host/model/tree.h"

namespace csgsim::facet {

/// A cone whose radius changes by less than this part of the greater one is the cylinder of its mean radius, half that
/// part of it away at most: its apex, as a place in double precision, would be known no better.
inline constexpr double least_taper = 0x1p-26;

/// Whether that stays a curved surface.
bool stays_curved(const model::Primitive& primitive, const Faceting& faceting);

/// The planes and a hull of a curved solid in its own space: the faces are its flat ends, and of a cone that ends in
/// its tip a plane through that, which parts it from the other nappe. Vertices and edges are those of a polytope around
/// it.
Solid curved_hull(const model::Sphere& sphere);
Solid curved_hull(const model::Cylinder& cylinder);

/// Its curved surface in model space.
CurvedSurface curved_surface(const model::Primitive& primitive);

}  // namespace csgsim::facet
