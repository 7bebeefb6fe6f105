#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/active_tree.h"
#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/base/work.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// What is drawn as one surface in a segment: a primitive, or several that make one convex solid.
struct PlannedSurface {
  csg::ConvexSet set;
  csg::Block block;
  csg::ActiveTree active;
  std::uint32_t number = 0;  ///< within its segment, from 1 on

  [[nodiscard]] std::uint32_t primitive() const { return set.front(); }
};

/// What a segment's instructions are made from, whatever the strategy.
struct SegmentPlan {
  isa::Region region;
  std::vector<PlannedSurface> surfaces;  ///< in tree order
  std::uint32_t active_primitives = 0;   ///< with pixels in the region
  std::uint32_t active_halfspaces = 0;   ///< of these
  isa::Preparation preparation;          ///< that this took

  [[nodiscard]] view::PixelRect pixels() const;
};

/// What a Program's instructions are made from.
struct Plan {
  csg::PositiveTree positive;
  std::vector<SegmentPlan> segments;
  isa::Preparation preparation;  ///< that this took before the first segment

  /// Levels of the deepest active tree.
  [[nodiscard]] std::uint32_t depth() const;
};

/// `opacity`, by primitive: those below 1 hide nothing, and no set mixes different ones; empty if all are 1. Throws
/// InputError, naming the primitive, past the limit on work.
Plan make_plan(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
               const std::vector<isa::Region>& regions, const csg::Pruning& pruning, const std::vector<double>& opacity,
               const Work& work);

}  // namespace csgsim::emit
