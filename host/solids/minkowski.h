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

/// Maximum number of corner pairs to be added.
inline constexpr std::size_t max_sums = 20'000'000;

/// The Minkowski sum of solids, from first to last, as in OpenSCAD; empty solids are skipped. For convex solids it is
/// the hull of the sums of their corners; otherwise the union of the pairwise sums of their pieces, which may overlap.
/// Pieces inside others are removed. Throws InputError if there are more than `max_sums` sums, and WorkError past the
/// limit on work.
Pieces minkowski(std::span<const Pieces> solids, const Work& work = {});

}  // namespace csgsim::solids
