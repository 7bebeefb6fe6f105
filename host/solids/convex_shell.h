#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/solids/regions.h"
#include "host/solids/shells.h"

namespace csgsim::solids {

/// A shell as it is, if it is convex: no corner is farther than `near` in front of a neighbour's plane, all planes have
/// the middle behind them, and the shell runs around it once. Regions are its faces, where their outlines are one each.
/// Takes time in proportion to its size.
std::optional<model::Polyhedron> as_convex(const Mesh& mesh, const FaceList& shell, const Neighbours& neighbours,
                                           const Regions& regions, double near);

}  // namespace csgsim::solids
