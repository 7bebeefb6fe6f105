#pragma once

#include <cstddef>
#include <cstdint>

#include "host/csg/positive_tree.h"
#include "host/facet/geometry.h"

namespace csgsim::convex {

/// Cuts of one convex part by one primitive, and operands of unions chosen, before what is left is taken as it is.
inline constexpr std::size_t most_extent_cuts = 2'000;

/// Steps of work (hw/base/work.h) before it is enough.
inline constexpr std::uint64_t most_extent_steps = 500'000'000;

/// The box of what the tree leaves of its primitives, within geometry.box. That is geometry.box where a corner of a
/// primitive on each of its sides is one of the model; else the box of the products' convex parts. A part that is
/// within the box of what is found already is not cut any further, and most are found by a corner that nothing takes
/// away. Loose, but never too small, where that takes more than `most` cuts or choices, and geometry.box past
/// `most_steps`. Sides that are geometry.box's within the tolerance of clip() are geometry.box's; the box of a model of
/// which nothing is left is.
facet::Box extent(const facet::Geometry& geometry, const csg::PositiveTree& tree, std::size_t most = most_extent_cuts,
                  std::uint64_t most_steps = most_extent_steps);

}  // namespace csgsim::convex
