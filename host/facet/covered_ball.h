#pragma once

#include "host/facet/solid.h"

namespace csgsim::facet {

/// A ball about the origin as few half-spaces that stay within `tolerance` of it, inwards: planes at the distance
/// h = radius - tolerance, whose normals cover the sphere by caps of angular radius acos(h / radius). No corner can be
/// farther out than the radius then. The caps are centres of cells in rows of latitude, in each row as few as reach
/// around, so there are some 2 pi / theta^2 of them, theta^2 = 2 tolerance / radius, against pi^2 / theta^2 of a mesh
/// of meridians. The vertices and edges are those of a hull that holds the ball, not of the half-spaces.
Solid covered_ball(double radius, double tolerance);

}  // namespace csgsim::facet
