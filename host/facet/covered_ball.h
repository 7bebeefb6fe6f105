// Faceting of a ball within a tolerance by few half-spaces.
// Used by solid.cpp.
#pragma once

#include "host/facet/solid.h"

namespace csgsim::facet {

/// Approximates a ball about the origin by few half-spaces that are at most `tolerance` inside the true surface. The
/// planes are at the distance h = radius - tolerance, and caps of angular radius acos(h / radius) around their normals
/// cover the sphere, so no corner is farther out than the radius. The normals are centres of cells in rows of latitude,
/// with the minimum number of cells in each row. This needs about 2 pi / theta^2 planes, with theta^2 = 2 tolerance /
/// radius, compared with pi^2 / theta^2 for a mesh of meridians. Vertices and edges are those of a hull that contains
/// the ball, not of the half-spaces.
Solid covered_ball(double radius, double tolerance);

}  // namespace csgsim::facet
