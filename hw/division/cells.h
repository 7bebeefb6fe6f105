#pragma once

#include <vector>

#include "hw/division/corners.h"
#include "hw/division/datapath.h"

namespace csgsim::division {

// Mutual elimination of the half-spaces of one side of a convex solid, by the rules of thesis table 7.1 and figure 7.5:
// the front of an intersection is where its planes are farthest (convex-max), its back where they are nearest
// (concave-min). A half-space is beyond another at a pixel if it is farther (for backs: nearer) by at least one depth
// step. If this holds at all four corners of a rectangle, it holds everywhere in the rectangle. The half-spaces passed
// in must be all fronts or all backs, with their values at the rectangle's corners.
//
// The leaders of a rectangle are the half-spaces with the extreme values at its corners; among equal ones, the first. A
// cell test compares a half-space with the leaders of a cell, a rectangle of pixels; it is counted for each half-space
// left in the cell.

/// Removes each half-space that a leader of the rectangle is beyond at all four corners. The rectangle is the only
/// cell.
void remove_behind_leaders(Datapath& path, std::vector<TestedHalfspace>& halfspaces, const Rectangle& pixels);

/// Removes the half-spaces that are behind others at every pixel. This is decided in cells: first the rectangle, then
/// its quarters, then their quarters, each with the half-spaces left by the enclosing cell, until every half-space is
/// decided (docs/machines/pixel-square.md).
void remove_hidden_halfspaces(Datapath& path, std::vector<TestedHalfspace>& halfspaces, const Rectangle& pixels);

}  // namespace csgsim::division
