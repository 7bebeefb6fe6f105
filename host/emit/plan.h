// The plan of a picture: the surfaces of each segment, with their active trees.
// Used by the emitter and sim/viewer.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "host/csg/active_tree.h"
#include "host/emit/options.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"
#include "hw/base/work.h"
#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::emit {

/// A surface of a segment: that of a primitive, or of several primitives that form one convex solid.
struct PlannedSurface {
  csg::ConvexSet set;
  csg::Block block;
  csg::ActiveTree active;
  std::uint32_t number = 0;  ///< number within its segment, from 1

  [[nodiscard]] std::uint32_t primitive() const { return set.front(); }
};

/// The input for a segment's instructions, independent of the strategy.
struct SegmentPlan {
  isa::Region region;
  std::vector<PlannedSurface> surfaces;  ///< in tree order
  std::uint32_t active_primitives = 0;   ///< primitives with pixels in the region
  std::uint32_t active_halfspaces = 0;   ///< half-spaces of these primitives
  isa::Preparation preparation;          ///< host work for this segment
  csg::Tested tested;                    ///< planes tested for this segment
  std::shared_ptr<csg::PairTable> pairs;

  [[nodiscard]] view::PixelRect pixels() const;
};

/// The input for a Program's instructions.
struct Plan {
  csg::PositiveTree positive;
  std::vector<SegmentPlan> segments;
  std::shared_ptr<csg::PairTable> pairs;
  csg::Tallies tallies;  ///< statistics of the prunings

  /// Number of levels of the deepest active tree.
  [[nodiscard]] std::uint32_t depth() const;
};

/// Settings for pruning a plan.
struct PlanSettings {
  csg::Pruning pruning;
  csg::Prices prices{};
  std::shared_ptr<csg::PairTable> pairs = nullptr;  ///< pair table of the geometry; null: a new one
  csg::KeptResults* kept = nullptr;                 ///< see csg::PrunerSettings; not used if they are of another model
};

/// `opacity` is by primitive: those below 1 hide nothing, and no set mixes different values; empty if all are 1. Throws
/// InputError, naming the primitive, if the work limit is exceeded.
Plan make_plan(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
               const std::vector<isa::Region>& regions, const PlanSettings& settings,
               const std::vector<double>& opacity, const Work& work);

}  // namespace csgsim::emit
