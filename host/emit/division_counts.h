// Counts of the divider's work for squares and groups of squares.
// Used by divided.cpp and its test.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/emit/options.h"
#include "host/emit/plan.h"
#include "host/facet/geometry.h"
#include "host/model/tree.h"
#include "host/view/projection.h"
#include "hw/division/counts.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

// The host computes these counts with its own data structures and the rules of docs/machines/pixel-square.md.

/// The divider's work for a surface, whether it is drawn or not, including the bounding boxes compared since the
/// previous surface. The number of its instructions is in the compiled Program. The last entry of a square counts the
/// boxes compared after the last surface.
struct SurfaceCounts {
  std::uint32_t primitive = model::no_index;  ///< first primitive of the surface; no_index in the last entry
  division::Counts counts;
};

using SquareCounts = std::vector<SurfaceCounts>;

/// Counts for each square, divided from the whole model.
std::vector<SquareCounts> count_division(const model::Tree& tree, const facet::Geometry& geometry,
                                         const view::View& view, const Options& options,
                                         std::span<const isa::Region> squares);

/// Counts for the squares of one group, divided from what remains for the group.
struct GroupCounts {
  division::Counts group;
  std::uint64_t entries = 0;  ///< primitives and half-spaces that remain for the group
  std::vector<SquareCounts> squares;
};

GroupCounts count_group_division(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                                 const Options& options, const isa::Region& group,
                                 std::span<const isa::Region> squares);

}  // namespace csgsim::emit
