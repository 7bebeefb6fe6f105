#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/active_tree.h"
#include "host/emit/options.h"
#include "host/facet/scene.h"
#include "host/view/projection.h"

namespace csgsim::emit {

/// What one primitive contributes to a segment.
struct Planned {
  std::uint32_t primitive;
  csg::Block block;
  csg::ActiveTree active;
};

/// What a segment's instructions are made from, whatever the strategy.
struct Plan {
  csg::PositiveTree positive;
  std::vector<Planned> primitives;      ///< in tree order
  std::uint32_t active_primitives = 0;  ///< with anything in the region
  std::uint32_t active_halfspaces = 0;  ///< of these
};

Plan make_plan(const model::Tree& tree, const facet::Scene& scene, const view::View& view,
               const view::PixelRect& region, const csg::Pruning& pruning);

}  // namespace csgsim::emit
