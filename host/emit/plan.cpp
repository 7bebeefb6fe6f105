#include "host/emit/plan.h"

#include <algorithm>

namespace csgsim::emit {

namespace {

/// Whether a primitive that nothing is taken from fills the block's pixels one depth step before the block, so that no
/// surface in it is seen.
bool hides(const Planned& front, const csg::Block& block, const facet::Scene& scene, const view::View& view,
           const csg::PositiveTree& positive) {
  if (!front.active.operands.empty() || positive.nodes[positive.leaf_of[front.primitive]].complemented) return false;
  const std::int64_t before = block.z_low - 1;
  return csg::locate(view, scene, front.primitive, {block.pixels, before, before}) == csg::Known::in;
}

void drop_hidden(Plan& plan, const facet::Scene& scene, const view::View& view) {
  // A primitive that hides another may be hidden itself: what hides it hides the other too.
  std::vector<const Planned*> nearest_first;
  for (const Planned& one : plan.primitives) nearest_first.push_back(&one);
  std::stable_sort(nearest_first.begin(), nearest_first.end(),
                   [](const Planned* a, const Planned* b) { return a->block.z_low < b->block.z_low; });
  const auto hidden = [&](const Planned& one) {
    for (const Planned* front : nearest_first) {
      if (front->block.z_low >= one.block.z_low) return false;
      if (hides(*front, one.block, scene, view, plan.positive)) return true;
    }
    return false;
  };
  std::vector<bool> drop;
  for (const Planned& one : plan.primitives) drop.push_back(one.block.z_low > 0 && hidden(one));
  std::size_t index = 0;
  std::erase_if(plan.primitives, [&](const Planned&) { return drop[index++]; });
}

}  // namespace

Plan make_plan(const model::Tree& tree, const facet::Scene& scene, const view::View& view,
               const view::PixelRect& region, const csg::Pruning& pruning) {
  Plan plan;
  plan.positive = csg::make_positive(tree);
  const csg::Pruner pruner(scene, view, plan.positive, region, pruning);
  for (std::uint32_t primitive = 0; primitive < tree.primitives.size(); ++primitive) {
    const csg::Block block = pruner.block_of(primitive);
    if (block.pixels.empty()) continue;
    ++plan.active_primitives;
    plan.active_halfspaces += static_cast<std::uint32_t>(scene.solids[primitive].halfspaces.size());
    csg::ActiveTree active = pruner.active_tree(primitive);
    if (!active.nothing) plan.primitives.push_back({primitive, block, std::move(active)});
  }
  if (pruning.hidden) drop_hidden(plan, scene, view);
  return plan;
}

}  // namespace csgsim::emit
