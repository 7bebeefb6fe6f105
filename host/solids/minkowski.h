// Minkowski sums of solids in convex pieces.
// Used by host/read.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

using Pieces = std::vector<model::Polyhedron>;  ///< convex pieces; their union is a solid

/// Maximum number of pairs of corners that are added.
inline constexpr std::size_t max_sums = 20'000'000;

/// The Minkowski sum of solids, from first to last, as in OpenSCAD; empty solids are skipped. The sum of convex solids
/// is the hull of the sums of their corners; otherwise it is the union of the pairwise sums of their pieces, which may
/// overlap. Pieces inside others are removed. Throws InputError if there are more than `max_sums` sums, and WorkError
/// if the work limit is exceeded.
Pieces minkowski(std::span<const Pieces> solids, const Work& work = {});

}  // namespace csgsim::solids
