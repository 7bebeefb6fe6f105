#pragma once

#include <vector>

#include "hw/division/corners.h"
#include "hw/division/datapath.h"

namespace csgsim::division {

// Mutual elimination of the half-spaces of one side of a convex solid, by the rules of thesis table 7.1 and figure 7.5:
// the front of an intersection is where its planes are farthest (convex-max), its back where they are nearest
// (concave-min). A half-space is beyond another at a pixel if it is farther (nearer for backs) by at least one depth
// step; if it is so at all four corners of a rectangle, it is so everywhere in it. All half-spaces passed in must be
// fronts, or all backs, with their values at the rectangle's corners.
//
// The leaders of a rectangle are the extremes at its corners; of equal ones, the first. A cell test compares a
// half-space with the leaders of a cell, a rectangle of pixels; all half-spaces left in the cell are tested.

/// Keeps the half-spaces that no leader of the rectangle is beyond at all four corners: a single cell.
void keep_by_leaders(Datapath& path, std::vector<Tested>& side, const Rectangle& pixels);

/// Keeps the half-spaces that are not behind others at every pixel. This is decided in cells: first the rectangle, then
/// its quarters, and their quarters, each with the half-spaces that the leaders of the enclosing cell leave, until
/// every half-space is decided (docs/machines/pixel-square.md).
void keep_extremes(Datapath& path, std::vector<Tested>& side, const Rectangle& pixels);

}  // namespace csgsim::division
