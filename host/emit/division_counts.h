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

// What the divider does, counted by the host's own means and by the rules of docs/machines/pixel-square.md alone.

/// What a surface takes, whether it is drawn or not, with the boxes since the one before; instructions apart, which a
/// compiled Program has. After the last come the boxes that are left.
struct SurfaceCounts {
  std::uint32_t primitive = model::no_index;  ///< its first; none after the last surface
  division::Counts counts;
};

using SquareCounts = std::vector<SurfaceCounts>;

/// For each square from the whole model.
std::vector<SquareCounts> count_division(const model::Tree& tree, const facet::Geometry& geometry,
                                         const view::View& view, const Options& options,
                                         std::span<const isa::Region> squares);

/// The same for the squares of one group, from what the group leaves.
struct GroupCounts {
  division::Counts group;
  std::uint64_t entries = 0;  ///< primitives and half-spaces that are left
  std::vector<SquareCounts> squares;
};

GroupCounts count_group(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                        const Options& options, const isa::Region& group, std::span<const isa::Region> squares);

}  // namespace csgsim::emit
