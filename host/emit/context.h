#pragma once

#include "host/emit/broadcast.h"
#include "host/emit/layout.h"
#include "host/emit/look.h"
#include "host/emit/options.h"
#include "host/emit/plan.h"
#include "hw/machines/machine.h"

namespace csgsim::emit {

/// What every part of the emitter reads while it works on one segment.
struct Context {
  const model::Tree& tree;
  const facet::Scene& scene;
  const view::View& view;
  const csg::PositiveTree& positive;
  const SegmentPlan& plan;
  const Layout& layout;
  const Options& options;
  const machines::Machine& machine;
  const Look& look;

  [[nodiscard]] std::int64_t farthest() const { return (std::int64_t{1} << view.sampling.z_bits) - 1; }
  [[nodiscard]] bool complemented(std::uint32_t primitive) const {
    return positive.nodes[positive.leaf_of[primitive]].complemented;
  }
  [[nodiscard]] const view::FixedLinear& linear_of(facet::Halfspace halfspace) const {
    return view.planes[halfspace.plane].linear;
  }
  [[nodiscard]] view::Range range_of(facet::Halfspace halfspace, const view::PixelRect& pixels) const {
    return csg::depth_range(view.planes[halfspace.plane], view.sampling.fraction_bits, pixels);
  }
};

}  // namespace csgsim::emit
