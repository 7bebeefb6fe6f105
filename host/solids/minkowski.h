#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "host/model/tree.h"
#include "hw/base/work.h"

namespace csgsim::solids {

using Pieces = std::vector<model::Polyhedron>;  ///< convex; their union is a solid

/// Sums of two corners that are looked at, at most.
inline constexpr std::size_t most_sums = 20'000'000;

/// The Minkowski sum of solids, from first to last, as in OpenSCAD: what is empty is passed over. Of convex solids it
/// is the hull of the sums of their corners; of others the union of those of their pieces, pair by pair, which overlap.
/// Pieces within others are left out. Throws InputError if there are more sums than `most_sums`, and WorkError past the
/// limit on work.
Pieces minkowski(std::span<const Pieces> solids, const Work& work = {});

}  // namespace csgsim::solids
