#include "host/emit/division_counts.h"

#include <algorithm>
#include <utility>

#include "host/csg/locate.h"
#include "host/emit/cell_tests.h"
#include "host/emit/context.h"
#include "host/emit/display_model.h"
#include "host/emit/halfspaces.h"
#include "host/emit/region_index.h"

namespace csgsim::emit {

namespace {

/// The half-spaces that the divider examines; none of a primitive that is not in its list.
struct Listed {
  std::vector<bool> primitives;
  std::vector<std::vector<facet::Halfspace>> halfspaces;  ///< sorted

  [[nodiscard]] bool has(const Facet& facet) const {
    const std::vector<facet::Halfspace>& own = halfspaces[facet.primitive];
    return std::binary_search(own.begin(), own.end(), facet.halfspace, is_less);
  }

  void sort() {
    for (std::vector<facet::Halfspace>& own : halfspaces) std::sort(own.begin(), own.end(), is_less);
  }

  static bool is_less(const facet::Halfspace& a, const facet::Halfspace& b) {
    return a.plane != b.plane ? a.plane < b.plane : !a.positive && b.positive;
  }
};

class Counter {
 public:
  Counter(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view, const Options& options)
      : tree_(tree),
        geometry_(geometry),
        view_(view),
        options_(divider_options(options)),
        positive_(csg::make_positive_tree(tree)) {
    // Only the leaders at the corners of a rectangle decide which half-spaces are dropped.
    options_.pruning.pixels = false;
    boxes_.resize(positive_.nodes.size());
    for (std::size_t i = 0; i < boxes_.size(); ++i) boxes_[i] = bounding_box(positive_.nodes[i]);
  }

  [[nodiscard]] Listed list_all() const {
    Listed listed;
    listed.primitives.assign(geometry_.solids.size(), true);
    for (std::uint32_t i = 0; i < geometry_.solids.size(); ++i) listed.halfspaces.push_back(sent(i));
    listed.sort();
    return listed;
  }

  /// Primitives and half-spaces that remain for a group of squares.
  Listed divide_group(const isa::Region& group, division::Counts& counts) const {
    Listed listed;
    listed.primitives.assign(geometry_.solids.size(), false);
    listed.halfspaces.resize(geometry_.solids.size());
    counts.boxes += geometry_.solids.size();
    SegmentPlan segment;
    segment.region = group;
    const Context context = context_for(segment);
    for (std::uint32_t i = 0; i < geometry_.solids.size(); ++i) {
      const view::PixelRect pixels = common(view_.extents[i].pixels, segment.pixels());
      if (view_.extents[i].empty() || pixels.empty()) continue;
      count_list(sent(i).size(), counts);
      const csg::Block column{pixels, 0, context.farthest()};
      bool nothing = false;
      for (const facet::Halfspace& halfspace : sent(i)) {
        const csg::Containment known = csg::locate(view_, halfspace, column);
        nothing = nothing || known == csg::Containment::out;
        if (view_.planes[halfspace.plane].kind == view::PlaneKind::edge && known != csg::Containment::in)
          listed.halfspaces[i].push_back(halfspace);
      }
      for (const view::Side side : {view::Side::front, view::Side::back}) {
        for (const Facet& facet : deciding_facets(context, {&i, 1}, side, column).facets)
          listed.halfspaces[i].push_back(facet.halfspace);
        if (!nothing)
          counts.cells += cells(context, cutting_facets(context, {&i, 1}, side, column).facets, pixels, false);
      }
      listed.primitives[i] = !nothing;
      if (nothing) listed.halfspaces[i].clear();
    }
    listed.sort();
    return listed;
  }

  std::vector<SquareCounts> squares(std::span<const isa::Region> squares, const Listed& listed) const {
    const Plan plan =
        make_plan(tree_, geometry_, view_, {squares.begin(), squares.end()}, {options_.pruning}, {}, options_.work);
    std::vector<SquareCounts> counts;
    const csg::Pruner pruner(geometry_, view_, positive_, *plan.pairs, {options_.pruning});
    const std::vector<csg::ConvexSet> sets = csg::convex_sets(positive_, true);
    const std::vector<std::vector<std::uint32_t>> active = sets_by_region(squares, sets, view_);
    const std::vector<std::uint64_t> boxes = boxes_before(sets, listed);
    for (std::size_t i = 0; i < squares.size(); ++i) {
      SquareCounts& square = counts.emplace_back();
      std::uint64_t looked_at = 0;
      for (const std::uint32_t number : active[i]) {
        if (!is_listed(sets[number], listed) || !has_box(sets[number], plan.segments[i])) continue;
        SurfaceCounts& surface = square.emplace_back();
        surface.primitive = sets[number].front();
        surface.counts = count_set(sets[number], plan.segments[i], pruner, listed);
        surface.counts.boxes = boxes[number + 1] - std::exchange(looked_at, boxes[number + 1]);
      }
      square.push_back({model::no_index, {.boxes = boxes.back() - looked_at}});
      add_cells(square, plan.segments[i], listed);
    }
    return counts;
  }

 private:
  using Box = csg::Block;

  [[nodiscard]] Box bounding_box(const csg::PositiveNode& node) const {
    if (node.is_leaf) {
      const view::Extent& extent = view_.extents[node.primitive];
      return {extent.pixels, extent.z_low, extent.z_high};
    }
    Box box{{}, 0, -1};
    for (const std::uint32_t child : node.children) {
      const Box& below = boxes_[child];
      if (below.pixels.empty()) continue;
      const bool first = box.pixels.empty();
      box = {hull(box.pixels, below.pixels), first ? below.z_low : std::min(box.z_low, below.z_low),
             first ? below.z_high : std::max(box.z_high, below.z_high)};
    }
    return box;
  }

  [[nodiscard]] static bool meet(const Box& a, const Box& b) {
    return !common(a.pixels, b.pixels).empty() && a.z_low <= b.z_high && b.z_low <= a.z_high;
  }

  [[nodiscard]] std::vector<facet::Halfspace> sent(std::uint32_t primitive) const {
    std::vector<facet::Halfspace> halfspaces;
    if (view_.extents[primitive].empty()) return halfspaces;
    for (const facet::Halfspace& halfspace : geometry_.solids[primitive].halfspaces) {
      if (view_.planes[halfspace.plane].representable) halfspaces.push_back(halfspace);
    }
    return halfspaces;
  }

  [[nodiscard]] Context context_for(const SegmentPlan& segment) const {
    return {tree_, geometry_, view_, positive_, segment, layout_, options_, machine_, look_};
  }

  /// Whether the boxes of all primitives of the set and the square have pixels and depths in common.
  [[nodiscard]] bool has_box(const csg::ConvexSet& set, const SegmentPlan& segment) const {
    Box box{segment.pixels(), 0, (std::int64_t{1} << view_.sampling.z_bits) - 1};
    for (const std::uint32_t primitive : set) {
      const view::Extent& extent = view_.extents[primitive];
      if (extent.empty()) return false;
      box = {common(box.pixels, extent.pixels), std::max(box.z_low, extent.z_low), std::min(box.z_high, extent.z_high)};
    }
    return !box.pixels.empty() && box.z_low <= box.z_high;
  }

  static void count_list(std::uint64_t halfspaces, division::Counts& counts) {
    counts.halfspaces += halfspaces;
    if (halfspaces > 0) ++counts.lists;
  }

  [[nodiscard]] static bool is_listed(std::span<const std::uint32_t> set, const Listed& listed) {
    return std::all_of(set.begin(), set.end(), [&](std::uint32_t one) { return listed.primitives[one]; });
  }

  /// Prefix sums of listed primitives: the number before each set, and the total.
  [[nodiscard]] static std::vector<std::uint64_t> boxes_before(std::span<const csg::ConvexSet> sets,
                                                               const Listed& listed) {
    std::vector<std::uint64_t> before{0};
    for (const csg::ConvexSet& set : sets) {
      const auto own = std::count_if(set.begin(), set.end(), [&](auto one) { return listed.primitives[one]; });
      before.push_back(before.back() + static_cast<std::uint64_t>(own));
    }
    return before;
  }

  /// Counts of examining a set whose boxes overlap the square.
  [[nodiscard]] division::Counts count_set(const csg::ConvexSet& set, const SegmentPlan& segment,
                                           const csg::Pruner& pruner, const Listed& listed) const {
    division::Counts counts;
    for (const std::uint32_t primitive : set) count_list(listed.halfspaces[primitive].size(), counts);
    const csg::Block block = pruner.surface_block(set, segment.pixels());
    if (!block.pixels.empty()) count_tree_nodes(set, block, listed, counts);
    return counts;
  }

  /// Adds the cell tests that drop redundant half-spaces of the remaining surfaces.
  void add_cells(SquareCounts& square, const SegmentPlan& segment, const Listed& listed) const {
    const Context context = context_for(segment);
    for (const PlannedSurface& planned : segment.surfaces) {
      const auto surface = std::ranges::find(square, planned.primitive(), &SurfaceCounts::primitive);
      if (surface != square.end()) count_thinning(context, planned, listed, surface->counts);
    }
  }

  /// Counts the nodes visited: the ancestors of the set's first leaf, the other operands of intersections among them,
  /// and the descendants of each node whose box meets the block.
  void count_tree_nodes(const csg::ConvexSet& set, const csg::Block& block, const Listed& listed,
                        division::Counts& counts) const {
    std::vector<std::uint32_t> open;
    std::uint32_t below = positive_.leaf_of[set.front()];
    for (std::uint32_t at = positive_.nodes[below].parent; at != model::no_index;
         below = at, at = positive_.nodes[at].parent) {
      ++counts.nodes;
      if (positive_.nodes[at].op != csg::PositiveOperator::intersect) continue;
      for (const std::uint32_t child : positive_.nodes[at].children) {
        if (child != below) open.push_back(child);
      }
    }
    while (!open.empty()) {
      const std::uint32_t at = open.back();
      open.pop_back();
      ++counts.nodes;
      if (!meet(boxes_[at], block)) continue;
      const csg::PositiveNode& node = positive_.nodes[at];
      open.insert(open.end(), node.children.begin(), node.children.end());
      if (node.is_leaf && std::find(set.begin(), set.end(), node.primitive) == set.end())
        count_list(listed.halfspaces[node.primitive].size(), counts);
    }
  }

  /// Number of cell tests of half-spaces of one side.
  [[nodiscard]] std::uint64_t cells(const Context& context, std::span<const Facet> facets,
                                    const view::PixelRect& pixels, bool quarters) const {
    if (facets.empty()) return 0;
    std::vector<view::FixedLinear> planes;
    for (const Facet& facet : facets) planes.push_back(context.linear_plane(facet.halfspace));
    const facet::Halfspace& first = facets.front().halfspace;
    const bool is_front = view::side_of(view_.planes[first.plane], first) == view::Side::front;
    return count_cell_tests(planes, is_front ? 1 : -1, std::int64_t{1} << view_.sampling.fraction_bits, pixels,
                            quarters);
  }

  /// Cell tests for the half-spaces of a side that are listed and do not contain the whole block.
  [[nodiscard]] std::uint64_t cells(const Context& context, std::span<const std::uint32_t> set, view::Side side,
                                    const csg::Block& block, const Listed& listed) const {
    DecidingFacets left = cutting_facets(context, set, side, block);
    if (left.nothing) return 0;
    std::erase_if(left.facets, [&](const Facet& facet) { return !listed.has(facet); });
    return cells(context, left.facets, block.pixels, true);
  }

  void count_thinning(const Context& context, const PlannedSurface& planned, const Listed& listed,
                      division::Counts& counts) const {
    const csg::Block column{planned.block.pixels, 0, context.farthest()};
    counts.cells += cells(context, planned.set, view::Side::front, column, listed) +
                    cells(context, planned.set, view::Side::back, column, listed);
    const Sides sides = deciding_sides(context, planned);
    const bool no_surface = context.complemented(planned.primitive()) && sides.backs.facets.empty();
    if (sides.fronts.nothing || sides.backs.nothing || no_surface) return;
    std::vector<std::uint32_t> open = planned.active.operands;
    while (!open.empty()) {
      const csg::ActiveNode& node = planned.active.nodes[open.back()];
      open.pop_back();
      open.insert(open.end(), node.children.begin(), node.children.end());
      if (!node.is_leaf) continue;
      std::vector<std::uint32_t> primitives = node.others;
      primitives.push_back(node.primitive);
      for (const std::uint32_t primitive : primitives) {
        const csg::Block part{common(planned.block.pixels, view_.extents[primitive].pixels), planned.block.z_low,
                              planned.block.z_high};
        for (const view::Side side : {view::Side::front, view::Side::back})
          counts.cells += cells(context, {&primitive, 1}, side, part, listed);
      }
    }
  }

  const model::Tree& tree_;
  const facet::Geometry& geometry_;
  const view::View& view_;
  Options options_;
  csg::PositiveTree positive_;
  Layout layout_;
  machines::Machine machine_;
  Look look_;
  std::vector<Box> boxes_;  ///< by node: bounding box of those of its primitives that have pixels
};

}  // namespace

std::vector<SquareCounts> count_division(const model::Tree& tree, const facet::Geometry& geometry,
                                         const view::View& view, const Options& options,
                                         std::span<const isa::Region> squares) {
  const Counter counter(tree, geometry, view, options);
  return counter.squares(squares, counter.list_all());
}

GroupCounts count_group_division(const model::Tree& tree, const facet::Geometry& geometry, const view::View& view,
                                 const Options& options, const isa::Region& group,
                                 std::span<const isa::Region> squares) {
  const Counter counter(tree, geometry, view, options);
  GroupCounts counts;
  const Listed listed = counter.divide_group(group, counts.group);
  counts.entries = static_cast<std::uint64_t>(std::count(listed.primitives.begin(), listed.primitives.end(), true));
  for (const auto& halfspaces : listed.halfspaces) counts.entries += halfspaces.size();
  counts.squares = counter.squares(squares, listed);
  return counts;
}

}  // namespace csgsim::emit
