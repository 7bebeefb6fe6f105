#include "host/emit/plan.h"

#include <algorithm>

namespace csgsim::emit {

namespace {

/// Whether a solid that nothing is taken from fills the block's pixels one depth step before the block, so that no
/// surface in it is seen.
bool hides(const PlannedSurface& front, const csg::Block& block, const facet::Scene& scene, const view::View& view,
           const csg::PositiveTree& positive) {
  if (!front.active.operands.empty() || positive.nodes[positive.leaf_of[front.primitive()]].complemented) return false;
  const std::int64_t before = block.z_low - 1;
  return std::all_of(front.set.begin(), front.set.end(), [&](std::uint32_t primitive) {
    return csg::locate(view, scene, primitive, {block.pixels, before, before}) == csg::Known::in;
  });
}

void drop_hidden(SegmentPlan& plan, const csg::PositiveTree& positive, const facet::Scene& scene,
                 const view::View& view, const std::vector<double>& opacity) {
  // A solid that hides another may be hidden itself: what hides it hides the other too.
  std::vector<const PlannedSurface*> nearest_first;
  for (const PlannedSurface& one : plan.surfaces)
    if (opacity.empty() || opacity[one.primitive()] >= 1) nearest_first.push_back(&one);
  std::stable_sort(nearest_first.begin(), nearest_first.end(),
                   [](const PlannedSurface* a, const PlannedSurface* b) { return a->block.z_low < b->block.z_low; });
  const auto hidden = [&](const PlannedSurface& one) {
    for (const PlannedSurface* front : nearest_first) {
      if (front->block.z_low >= one.block.z_low) return false;
      if (hides(*front, one.block, scene, view, positive)) return true;
    }
    return false;
  };
  std::vector<bool> drop;
  for (const PlannedSurface& one : plan.surfaces) drop.push_back(one.block.z_low > 0 && hidden(one));
  std::size_t index = 0;
  std::erase_if(plan.surfaces, [&](const PlannedSurface&) { return drop[index++]; });
}

/// The sets; of those that hold primitives of different opacities each primitive on its own.
std::vector<csg::ConvexSet> unmixed(const std::vector<csg::ConvexSet>& sets, const std::vector<double>& opacity) {
  if (opacity.empty()) return sets;
  std::vector<csg::ConvexSet> result;
  for (const csg::ConvexSet& set : sets) {
    const auto is_other = [&](std::uint32_t one) { return opacity[one] != opacity[set.front()]; };
    if (std::none_of(set.begin(), set.end(), is_other)) {
      result.push_back(set);
    } else {
      for (const std::uint32_t one : set) result.push_back({one});
    }
  }
  return result;
}

/// Counts the primitives that have pixels in the region, pruned or not.
void count_active(SegmentPlan& plan, const facet::Scene& scene, const view::View& view) {
  for (std::size_t primitive = 0; primitive < scene.solids.size(); ++primitive) {
    const view::Extent& extent = view.extents[primitive];
    if (extent.empty() || common(extent.pixels, plan.pixels()).empty()) continue;
    ++plan.active_primitives;
    plan.active_halfspaces += static_cast<std::uint32_t>(scene.solids[primitive].halfspaces.size());
  }
}

}  // namespace

view::PixelRect SegmentPlan::pixels() const {
  const auto x = static_cast<std::int32_t>(region.x);
  const auto y = static_cast<std::int32_t>(region.y);
  return {x, y, x + static_cast<std::int32_t>(region.width) - 1, y + static_cast<std::int32_t>(region.height) - 1};
}

std::uint32_t Plan::depth() const {
  std::uint32_t deepest = 0;
  for (const SegmentPlan& segment : segments) {
    for (const PlannedSurface& one : segment.surfaces) deepest = std::max(deepest, one.active.depth());
  }
  return deepest;
}

Plan make_plan(const model::Tree& tree, const facet::Scene& scene, const view::View& view,
               const std::vector<isa::Region>& regions, const csg::Pruning& pruning,
               const std::vector<double>& opacity) {
  Plan plan;
  plan.positive = csg::make_positive(tree);
  const std::vector<csg::ConvexSet> sets = unmixed(csg::convex_sets(plan.positive, pruning.sets), opacity);
  const csg::Pruner pruner(scene, view, plan.positive, pruning);
  for (const isa::Region& region : regions) {
    SegmentPlan& segment = plan.segments.emplace_back();
    segment.region = region;
    count_active(segment, scene, view);
    for (const csg::ConvexSet& set : sets) {
      const csg::Block block = pruner.block_of(set, segment.pixels());
      if (block.pixels.empty()) continue;
      csg::ActiveTree active = pruner.active_tree(set, block);
      if (!active.nothing) segment.surfaces.push_back({set, block, std::move(active), 0});
    }
    if (pruning.hidden) drop_hidden(segment, plan.positive, scene, view, opacity);
    std::uint32_t number = 0;
    for (PlannedSurface& one : segment.surfaces) one.number = ++number;
  }
  return plan;
}

}  // namespace csgsim::emit
