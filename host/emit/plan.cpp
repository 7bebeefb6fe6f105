#include "host/emit/plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "host/csg/kept_results.h"
#include "host/emit/region_index.h"
#include "hw/base/error.h"
#include "hw/isa/host_counts.h"

namespace csgsim::emit {

namespace {

/// Maximum number of solids tested for hiding one surface: in a model with very many small pieces, thousands may be in
/// front of each. Keeping a hidden surface costs clocks but does not change the picture.
constexpr std::size_t max_hiders = 256;

/// Solids that nothing is subtracted from; they may hide the surfaces behind them.
class Hiders {
 public:
  Hiders(const std::vector<PlannedSurface>& surfaces, const csg::PositiveTree& positive,
         const facet::Geometry& geometry, const view::View& view, const std::vector<double>& opacity,
         const csg::Counted& counted)
      : surfaces_(surfaces),
        geometry_(geometry),
        view_(view),
        counted_(counted),
        index_(entries(surfaces, positive, view, opacity)) {}

  /// Number of boxes compared to find those in front of a block.
  [[nodiscard]] std::uint64_t boxes() const { return index_.path_boxes(); }

  /// Whether one of them fills the block's pixels one depth step in front of the block, so that no surface in the block
  /// is visible. It may be hidden itself: whatever hides it also hides the block.
  [[nodiscard]] bool hide(const csg::Block& block) const {
    if (block.z_low <= 0) return false;
    const std::int64_t before = block.z_low - 1;
    counted_.add(&isa::Preparation::boxes, index_.path_boxes());
    const std::vector<std::uint32_t> fronts =
        index_.covering(csg::picture_box(block.pixels, before, before), max_hiders);
    return std::any_of(fronts.begin(), fronts.end(), [&](std::uint32_t number) {
      const PlannedSurface& front = surfaces_[number];
      return front.block.z_low < block.z_low &&
             std::all_of(front.set.begin(), front.set.end(), [&](std::uint32_t primitive) {
               return csg::holds(view_, geometry_, primitive, {block.pixels, before, before}, counted_);
             });
    });
  }

 private:
  static csg::BoxIndex entries(const std::vector<PlannedSurface>& surfaces, const csg::PositiveTree& positive,
                               const view::View& view, const std::vector<double>& opacity) {
    std::vector<csg::BoxIndex::Entry> boxes;
    for (std::uint32_t i = 0; i < surfaces.size(); ++i) {
      const PlannedSurface& one = surfaces[i];
      const bool is_whole =
          one.active.operands.empty() && !positive.nodes[positive.leaf_of[one.primitive()]].complemented;
      const bool is_opaque = opacity.empty() || opacity[one.primitive()] >= 1;
      if (!is_whole || !is_opaque) continue;
      csg::Block block{view.extents[one.primitive()].pixels, 0, std::numeric_limits<std::int64_t>::max()};
      for (const std::uint32_t primitive : one.set) {
        const view::Extent& extent = view.extents[primitive];
        block = {common(block.pixels, extent.pixels), std::max(block.z_low, extent.z_low),
                 std::min(block.z_high, extent.z_high)};
      }
      boxes.push_back({csg::picture_box(block.pixels, block.z_low, block.z_high), i});
    }
    return csg::BoxIndex(boxes);
  }

  const std::vector<PlannedSurface>& surfaces_;
  const facet::Geometry& geometry_;
  const view::View& view_;
  csg::Counted counted_;
  csg::BoxIndex index_;
};

/// Estimated instructions that draw a surface and compare it with others.
double surface_instructions(const PlannedSurface& surface, const facet::Geometry& geometry) {
  constexpr double around = 10;  // enabling pixels, depth test and merge
  const auto bounds = [&](std::uint32_t primitive) {
    return static_cast<double>(geometry.solids[primitive].halfspaces.size() +
                               geometry.solids[primitive].quadrics.size());
  };
  double count = around;
  for (const std::uint32_t primitive : surface.set) count += bounds(primitive);
  for (const csg::ActiveNode& node : surface.active.nodes) {
    if (!node.is_leaf) continue;
    count += bounds(node.primitive);
    for (const std::uint32_t other : node.others) count += bounds(other);
  }
  return count;
}

/// Half-spaces that are usually tested until one shows that a solid does not hide a block.
constexpr double usual_tests = 4;

void drop_hidden(SegmentPlan& plan, const csg::PositiveTree& positive, const facet::Geometry& geometry,
                 const view::View& view, const std::vector<double>& opacity, const csg::Prices& prices,
                 csg::Tally& tally) {
  if (plan.surfaces.size() < 2) return;
  const csg::Counted counted(plan.preparation, &plan.tested);
  counted.add(&isa::Preparation::boxes, plan.surfaces.size());
  const Hiders hiders(plan.surfaces, positive, geometry, view, opacity, counted);
  std::vector<bool> drop;
  const double price = static_cast<double>(hiders.boxes()) * prices.box + usual_tests * prices.test;
  for (const PlannedSurface& one : plan.surfaces) {
    const double saved = surface_instructions(one, geometry);
    const bool is_tested = prices.is_worthwhile(saved, price);
    drop.push_back(is_tested && hiders.hide(one.block));
    is_tested ? tally.add(drop.back(), saved, price) : void(++tally.left);
  }
  std::size_t index = 0;
  std::erase_if(plan.surfaces, [&](const PlannedSurface&) { return drop[index++]; });
}

/// The sets, where sets of primitives with different opacities are split into single primitives.
std::vector<csg::ConvexSet> split_by_opacity(const std::vector<csg::ConvexSet>& sets,
                                             const std::vector<double>& opacity) {
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

/// Estimated work of comparing a surface with others: a cost per half-space, and a fixed overhead per solid.
std::uint64_t comparison_steps(const csg::ActiveTree& active, const facet::Geometry& geometry) {
  constexpr std::uint64_t of_halfspace = 100;
  constexpr std::uint64_t of_solid = 20;
  std::uint64_t count = 0;
  for (const csg::ActiveNode& node : active.nodes) {
    if (!node.is_leaf) continue;
    count += of_solid + geometry.solids[node.primitive].halfspaces.size();
    for (const std::uint32_t other : node.others) count += geometry.solids[other].halfspaces.size();
  }
  return of_halfspace * count;
}

void charge_comparisons(const csg::ActiveTree& active, const facet::Geometry& geometry, const model::Tree& tree,
                        std::uint32_t primitive, const Work& work) {
  try {
    work.charge(comparison_steps(active, geometry), "comparing primitives with others");
  } catch (const WorkError& error) {
    throw InputError(
        fmt::format("{}: from this primitive on, {}", model::location_text(tree, primitive), error.what()));
  }
}

/// Counts the primitives with pixels in each region, pruned or not.
void count_active(std::vector<SegmentPlan>& segments, const std::vector<isa::Region>& regions,
                  const facet::Geometry& geometry, const view::View& view) {
  RegionIndex index(regions);
  for (std::size_t primitive = 0; primitive < geometry.solids.size(); ++primitive) {
    const view::Extent& extent = view.extents[primitive];
    if (extent.empty()) continue;
    index.for_each(extent.pixels, [&](std::uint32_t region) {
      ++segments[region].active_primitives;
      segments[region].active_halfspaces += static_cast<std::uint32_t>(geometry.solids[primitive].halfspaces.size() +
                                                                       geometry.solids[primitive].quadrics.size());
    });
  }
}

}  // namespace

view::PixelRect SegmentPlan::pixels() const { return region_pixels(region); }

std::uint32_t Plan::depth() const {
  std::uint32_t deepest = 0;
  for (const SegmentPlan& segment : segments) {
    for (const PlannedSurface& one : segment.surfaces) deepest = std::max(deepest, one.active.depth());
  }
  return deepest;
}

Plan make_plan(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
               const std::vector<isa::Region>& regions, const PlanSettings& settings,
               const std::vector<double>& opacity, const Work& work) {
  Plan plan;
  const csg::Pruning& pruning = settings.pruning;
  plan.pairs = settings.pairs != nullptr ? settings.pairs : std::make_shared<csg::PairTable>(geometry);
  plan.positive = csg::make_positive_tree(tree);
  const std::vector<csg::ConvexSet> sets = split_by_opacity(csg::convex_sets(plan.positive, pruning.sets), opacity);
  isa::Preparation counted;
  csg::Tested tested;
  const bool is_kept = settings.kept != nullptr && settings.kept->applies_to(tree, pruning);
  const csg::Pruner pruner(
      geometry, view, plan.positive, *plan.pairs,
      {pruning, settings.prices, csg::Counted(counted, &tested), is_kept ? settings.kept : nullptr});
  const std::vector<std::vector<std::uint32_t>> active_sets = sets_by_region(regions, sets, view);
  plan.segments.resize(regions.size());
  for (std::size_t i = 0; i < regions.size(); ++i) plan.segments[i].region = regions[i];
  count_active(plan.segments, regions, geometry, view);
  for (std::size_t i = 0; i < regions.size(); ++i) {
    SegmentPlan& segment = plan.segments[i];
    counted = {};
    counted.boxes = active_sets[i].size();
    tested = {};
    if (i > 0) tested.follow(plan.segments[i - 1].tested);
    for (const std::uint32_t number : active_sets[i]) {
      const csg::ConvexSet& set = sets[number];
      const csg::Block block = pruner.surface_block(set, segment.pixels());
      if (block.pixels.empty()) continue;
      csg::ActiveTree active = pruner.active_tree(set, block);
      if (active.nothing) continue;
      charge_comparisons(active, geometry, tree, set.front(), work);
      segment.surfaces.push_back({set, block, std::move(active), 0});
    }
    segment.preparation = counted;
    segment.tested = std::move(tested);
    segment.pairs = plan.pairs;
    if (pruning.hidden)
      drop_hidden(segment, plan.positive, geometry, view, opacity, settings.prices, plan.tallies.hidden);
    segment.tested.seal();
    std::uint32_t number = 0;
    for (PlannedSurface& one : segment.surfaces) one.number = ++number;
  }
  const csg::Tally hidden = plan.tallies.hidden;
  plan.tallies = pruner.tallies();
  plan.tallies.hidden = hidden;
  return plan;
}

}  // namespace csgsim::emit
