// Bounding box of a model after its Boolean operations.
// Used by host/setup and sim/software.
#pragma once

#include <cstddef>
#include <cstdint>

#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"

namespace csgsim::convex {

/// Maximum number of cuts of a convex part by a primitive plus choices of a union's operand; the box may be loose if
/// more are needed.
inline constexpr std::size_t max_extent_cuts = 2'000;

/// Maximum cost in steps of work (hw/base/work.h); if more are needed, the box is geometry.box.
inline constexpr std::uint64_t max_extent_steps = 500'000'000;

/// The bounding box of the model, within geometry.box. It is geometry.box if each side of that box has a primitive's
/// corner that belongs to the model; otherwise it is the box of the products' convex parts. A part inside the current
/// box is not cut any further, and most parts are decided by a corner that no primitive removes. The box is never too
/// small, but may be loose after more than `max_cuts` cuts or choices; after `max_steps` it is geometry.box. Sides that
/// differ from those of geometry.box by less than the tolerance of clip() are set to those of geometry.box. The box of
/// an empty model is geometry.box.
facet::Box extent(const facet::Geometry& geometry, const csg::PositiveTree& tree,
                  std::size_t max_cuts = max_extent_cuts, std::uint64_t max_steps = max_extent_steps);

}  // namespace csgsim::convex
