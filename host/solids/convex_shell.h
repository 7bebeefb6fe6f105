// Recognition of convex shells, which need no cutting.
// Used by pieces.cpp.
#pragma once

#include <optional>

#include "host/model/tree.h"
#include "host/solids/regions.h"
#include "host/solids/shells.h"

namespace csgsim::solids {

/// Returns a shell unchanged if it is convex: no corner is more than `near` in front of a neighbour's plane, the centre
/// is behind all planes, and the shell winds around it once. The faces of the result are the regions. Empty if the
/// shell is not convex or a region has more than one outline. Takes time proportional to the size of the shell.
std::optional<model::Polyhedron> as_convex(const Mesh& mesh, const FaceList& shell, const Neighbours& neighbours,
                                           const Regions& regions, double near);

}  // namespace csgsim::solids
