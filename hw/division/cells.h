#pragma once

#include <vector>

#include "hw/division/corners.h"
#include "hw/division/datapath.h"

namespace csgsim::division {

// What the half-spaces of one side of a convex solid leave of each other, by the rules of thesis table 7.1 and figure
// 7.5: the front of an intersection is where its planes are farthest (convex-max), its back where they are nearest
// (concave-min). One is beyond another, at a pixel, by a whole depth step; at all four corners of a rectangle is
// everywhere in it. All of a side have to be fronts, or all backs, with their values for the rectangle's corners.
//
// Leaders of a rectangle are the extremes at its corners, of equals the first. A cell test holds a half-space against
// the leaders of a cell, a rectangle of pixels: of each cell all that is left in it.

/// Keeps those that no leader of the rectangle is beyond at all four corners: one cell.
void keep_by_leaders(Datapath& path, std::vector<Tested>& side, const Rectangle& pixels);

/// Keeps those that are not behind others at every pixel. Whether one is, is found in cells: first the rectangle, then
/// its quarters, and theirs, with what the leaders of the cell above leave, until it is known of all
/// (docs/machines/pixel-square.md).
void keep_extremes(Datapath& path, std::vector<Tested>& side, const Rectangle& pixels);

}  // namespace csgsim::division
