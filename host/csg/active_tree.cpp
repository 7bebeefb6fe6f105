#include "host/csg/active_tree.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "host/csg/kept_results.h"
#include "host/csg/separation.h"
#include "hw/isa/host_counts.h"

namespace csgsim::csg {

namespace {

/// Adds a node to the operands of an operator. If the node has the same operator, its operands are added instead, and
/// the node is left empty.
void keep(ActiveTree& tree, std::uint32_t index, PositiveOperator op, std::vector<std::uint32_t>& operands) {
  ActiveNode& node = tree.nodes[index];
  if (node.is_leaf || node.op != op) {
    operands.push_back(index);
    return;
  }
  // The smaller list is appended to the larger one, so that deep trees take no longer than wide ones.
  if (node.children.size() > operands.size()) std::swap(node.children, operands);
  operands.insert(operands.end(), node.children.begin(), node.children.end());
  node.children.clear();
}

/// Narrows the depths to those between the solid's fronts and backs over the block's pixels.
void tighten(Block& block, const view::View& view, const facet::Convex& solid, const Counted& counted) {
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    if (!plane.representable) continue;
    counted.test(plane.linear, block.pixels);
    const view::Side side = view::side_of(plane, halfspace);
    if (side == view::Side::front) {
      block.z_low = std::max(block.z_low, depth_range(plane, view.sampling.fraction_bits, block.pixels).low);
    } else if (side == view::Side::back) {
      block.z_high = std::min(block.z_high, depth_range(plane, view.sampling.fraction_bits, block.pixels).high);
    } else if (locate(view, halfspace, block) == Containment::out) {
      block.z_high = block.z_low - 1;
    }
  }
}

/// Number of results to hold for an operator whose operands are sorted by need, greatest first (Ershov, Sethi and
/// Ullman).
std::uint32_t bits_needed(const std::vector<ActiveNode>& nodes, const std::vector<std::uint32_t>& children) {
  std::uint32_t bits = 1;
  for (std::size_t i = 0; i < children.size(); ++i) {
    const std::uint32_t below = nodes[children[i]].bits;
    if (below > 0) bits = std::max(bits, i == 0 ? below : below + 1);
  }
  return bits;
}

}  // namespace

std::uint32_t ActiveTree::bits() const {
  std::uint32_t most = 0;
  for (const std::uint32_t operand : operands) most = std::max(most, nodes[operand].bits);
  return most;
}

std::uint32_t ActiveTree::depth() const {
  std::vector<std::uint32_t> depths(nodes.size(), 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    for (const std::uint32_t child : nodes[i].children) depths[i] = std::max(depths[i], depths[child] + 1);
  }
  std::uint32_t deepest = 0;
  for (const std::uint32_t operand : operands) deepest = std::max(deepest, depths[operand]);
  return operands.size() > 1 ? deepest + 1 : deepest;
}

/// The block in which a set's surface is examined.
struct Pruner::SurfaceQuery {
  Block block;
  std::span<const std::uint32_t> set;
  KeptResults::Search* search = nullptr;  ///< the search for the tree, where results are kept
};

struct Pruner::Pruned {
  Containment known = Containment::depends;
  std::uint32_t node = model::no_index;  ///< index in the active tree, if `known` is depends
};

namespace {

/// Up to this number of primitives, an I-tree is scanned linearly instead of with the index.
constexpr std::uint32_t few_primitives = 32;

/// Number of intersections above a primitive whose other operands are searched separately; those of further
/// intersections are searched together, including what is between them.
constexpr unsigned few_intersections = 8;

BoxIndex make_index(const view::View& view) {
  std::vector<BoxIndex::Entry> entries;
  for (std::uint32_t i = 0; i < view.extents.size(); ++i) {
    const view::Extent& extent = view.extents[i];
    if (!extent.pixels.empty()) entries.push_back({picture_box(extent.pixels, extent.z_low, extent.z_high, i, i), i});
  }
  return BoxIndex(entries);
}

}  // namespace

Pruner::Pruner(const facet::Geometry& geometry, const view::View& view, const PositiveTree& tree, PairTable& pairs,
               const PrunerSettings& settings)
    : geometry_(geometry),
      view_(view),
      tree_(tree),
      pruning_(settings.pruning),
      prices_(settings.prices),
      counted_(settings.counted),
      paths_(tree),
      pairs_(pairs),
      kept_(settings.kept) {
  if (pruning_.picture && view.extents.size() > few_primitives) boxes_ = make_index(view);
}

Block Pruner::surface_block(std::span<const std::uint32_t> set, const view::PixelRect& region) const {
  Block block{region, 0, std::numeric_limits<std::int64_t>::max()};
  for (const std::uint32_t primitive : set) {
    counted_.add(&isa::Preparation::boxes);
    const view::Extent& extent = view_.extents[primitive];
    if (extent.empty()) return {};
    block.pixels = common(block.pixels, extent.pixels);
    block.z_low = std::max(block.z_low, extent.z_low);
    block.z_high = std::min(block.z_high, extent.z_high);
  }
  if (block.pixels.empty() || block.z_low > block.z_high) return {};
  if (pruning_.halfspaces) {
    for (const std::uint32_t primitive : set) tighten(block, view_, geometry_.solids[primitive], counted_);
  }
  return block.z_low > block.z_high ? Block{} : block;
}

bool Pruner::disjoint(std::uint32_t primitive, const SurfaceQuery& query) const {
  const Block& block = query.block;
  const view::Extent& extent = view_.extents[primitive];
  const bool picture =
      common(extent.pixels, block.pixels).empty() || extent.z_low > block.z_high || extent.z_high < block.z_low;
  if (pruning_.picture) counted_.add(&isa::Preparation::boxes);
  return (pruning_.picture && picture) ||
         (pruning_.space && std::any_of(query.set.begin(), query.set.end(),
                                        [&](std::uint32_t other) { return have_disjoint_boxes(primitive, other); }));
}

/// Appends the primitives in [first, end) that are not disjoint from the block, in order.
void Pruner::find(std::uint32_t first, std::uint32_t end, const SurfaceQuery& query,
                  std::vector<std::uint32_t>& found) const {
  const std::size_t begin = found.size();
  if (!boxes_ || end - first <= few_primitives) {
    for (std::uint32_t i = first; i < end; ++i) found.push_back(i);
  } else {
    const Block& block = query.block;
    counted_.add(&isa::Preparation::boxes, boxes_->path_boxes());
    boxes_->meeting(picture_box(block.pixels, block.z_low, block.z_high, first, end - 1), found);
  }
  const auto is_elsewhere = [&](std::uint32_t one) { return one < first || one >= end || disjoint(one, query); };
  const auto new_begin = found.begin() + static_cast<std::ptrdiff_t>(begin);
  found.erase(std::remove_if(new_begin, found.end(), is_elsewhere), found.end());
}

std::vector<std::uint32_t> Pruner::meeting(std::span<const std::uint32_t> set, const Block& block) const {
  const SurfaceQuery query{block, set};
  std::vector<std::uint32_t> found;
  const std::uint32_t leaf = tree_.leaf_of[set.front()];
  std::uint32_t operand = paths_.operand_above(leaf);
  // The primitives from `first` to `last` have been examined, or are not in the I-tree.
  std::uint32_t first = set.front();
  std::uint32_t last = first;
  for (unsigned i = 0; operand != model::no_index; ++i) {
    counted_.add(&isa::Preparation::nodes);
    const bool all_others = i == few_intersections;
    const std::uint32_t node = all_others ? paths_.top_intersection(leaf) : tree_.nodes[operand].parent;
    if (!all_others) {
      first = paths_.first(operand);
      last = paths_.last(operand);
    }
    find(paths_.first(node), first, query, found);
    find(last + 1, paths_.last(node) + 1, query, found);
    first = paths_.first(node);
    last = paths_.last(node);
    operand = all_others ? model::no_index : paths_.operand_above(node);
  }
  std::sort(found.begin(), found.end());
  return found;
}

/// Estimated instructions that compare a primitive with Z1.
double Pruner::comparison_instructions(std::uint32_t primitive) const {
  constexpr double around = 3;  // for the result of the comparison
  const facet::Convex& solid = geometry_.solids[primitive];
  return around + static_cast<double>(solid.halfspaces.size() + solid.quadrics.size());
}

/// Whether the boxes in model space are disjoint; false if the test is not worth its time.
bool Pruner::have_disjoint_boxes(std::uint32_t first, std::uint32_t second) const {
  const double saved = comparison_instructions(first);
  if (!prices_.is_worthwhile(saved, prices_.box)) {
    ++tallies_.space.left;
    return false;
  }
  counted_.add(&isa::Preparation::boxes);
  const bool are_disjoint = csg::disjoint(view_.extents[first].box, view_.extents[second].box);
  tallies_.space.add(are_disjoint, saved, prices_.box);
  return are_disjoint;
}

/// Whether a plane separates the primitives; false if the search is not worth its time.
bool Pruner::are_apart(std::uint32_t first, std::uint32_t second) const {
  const double saved = comparison_instructions(first);
  if (!prices_.is_worthwhile(saved, pairs_.price(first, second, prices_))) {
    ++tallies_.separation.left;
    return false;
  }
  const std::uint64_t before = pairs_.work().supports;
  const bool are_apart = pairs_.are_apart(first, second, view_, counted_);
  const auto supports = static_cast<double>(pairs_.work().supports - before + 1);
  tallies_.separation.add(are_apart, saved, supports * prices_.support);
  return are_apart;
}

/// Whether the half-spaces of a primitive contain or exclude the block; Containment::depends if the test is not worth
/// its time. The extremes of the half-spaces are needed for the comparison's instructions anyway.
Containment Pruner::locate_primitive(std::uint32_t primitive, const SurfaceQuery& query) const {
  const double saved = comparison_instructions(primitive);
  if (!prices_.is_worthwhile(saved, prices_.box)) {
    ++tallies_.halfspaces.left;
    return Containment::depends;
  }
  Excluder* const excluder = kept_ == nullptr ? nullptr : kept_->excluder(query.set.front(), primitive);
  const Containment known = locate(view_, geometry_, primitive, query.block, counted_, excluder);
  if (excluder != nullptr && excluder->held) kept_->count_certificate();
  tallies_.halfspaces.add(known != Containment::depends, saved, prices_.box);
  return known;
}

/// Location of the block relative to a leaf, complemented or not. The cheaper test comes first.
Containment Pruner::locate_leaf(const PositiveNode& leaf, const SurfaceQuery& query) const {
  Containment known = pruning_.halfspaces ? locate_primitive(leaf.primitive, query) : Containment::depends;
  const auto is_apart = [&](std::uint32_t primitive) { return are_apart(leaf.primitive, primitive); };
  if (known == Containment::depends && pruning_.separation && std::any_of(query.set.begin(), query.set.end(), is_apart))
    known = Containment::out;
  if (known == Containment::depends || !leaf.complemented) return known;
  return known == Containment::in ? Containment::out : Containment::in;
}

/// Location of the block relative to a leaf that is not disjoint from it. Leaves of the set itself contain its surface.
Containment Pruner::known(const PositiveNode& leaf, const SurfaceQuery& query) const {
  const bool in_set = std::binary_search(query.set.begin(), query.set.end(), leaf.primitive);
  return in_set ? Containment::in : locate_leaf(leaf, query);
}

/// The leading primitives of `primitives` that are below the node; at least the first must be.
Pruner::Primitives Pruner::below(std::uint32_t node, Primitives primitives) const {
  return primitives.first(static_cast<std::size_t>(
      std::upper_bound(primitives.begin(), primitives.end(), paths_.last(node)) - primitives.begin()));
}

/// Counts a visit of a tree node.
void Pruner::visit() const {
  ++visits_;
  counted_.add(&isa::Preparation::nodes);
}

/// Whether a child that contains none of these primitives decides the node; the value of such a child is the one
/// outside all its primitives.
bool Pruner::is_decided_elsewhere(std::uint32_t node, Primitives meeting) const {
  std::uint32_t deciding = paths_.deciding_children(node);
  while (deciding > 0 && !meeting.empty()) {
    visit();
    const std::uint32_t child = paths_.child_towards(node, meeting.front());
    if (paths_.decides_elsewhere(child)) --deciding;
    meeting = meeting.subspan(below(child, meeting).size());
  }
  return deciding > 0;
}

/// Prunes a part of the tree without recursion, so that deep trees do not overflow the stack. It visits only the
/// operators at which the paths to primitives that meet the block join.
class Pruner::Traversal {
 public:
  Traversal(const Pruner& pruner, const SurfaceQuery& query, ActiveTree& into)
      : pruner_(pruner), query_(query), into_(into) {}

  /// `meeting`: the primitives at or below the root that are not disjoint from the block; at least one.
  Pruned prune(std::uint32_t root, Primitives meeting) {
    bool has_result = !begin(root, meeting);
    while (!open_.empty()) {
      Visit& visit = open_.back();
      const bool is_decided = has_result && !take_result(visit);
      if (!is_decided && !visit.left.empty()) {
        const std::uint32_t child = pruner_.paths_.child_towards(visit.node, visit.left.front());
        const Primitives some = pruner_.below(child, visit.left);
        visit.left = visit.left.subspan(some.size());
        has_result = !begin(child, some);
        continue;
      }
      if (!is_decided) finish(visit);
      open_.pop_back();
      has_result = true;
    }
    return result_;
  }

 private:
  struct Visit {
    std::uint32_t node;
    Primitives left;         ///< primitives below children that have not been visited
    std::size_t first_node;  ///< size of the active tree before this visit
    std::vector<std::uint32_t> kept{};
  };

  /// Visits a node. Returns false if its result is known; otherwise its operands have to be visited.
  bool begin(std::uint32_t top, Primitives some) {
    pruner_.visit();
    const TreePaths& paths = pruner_.paths_;
    const std::vector<std::uint32_t>& leaf_of = pruner_.tree_.leaf_of;
    const std::uint32_t index = paths.common_ancestor(leaf_of[some.front()], leaf_of[some.back()]);
    const PositiveNode& node = pruner_.tree_.nodes[index];
    if (paths.is_decided_between(index, top) || pruner_.is_decided_elsewhere(index, some)) {
      result_ = {paths.is_inside_elsewhere(top) ? Containment::in : Containment::out, model::no_index};
      return false;
    }
    if (!node.is_leaf) {
      open_.push_back({index, some, into_.nodes.size()});
      return true;
    }
    const auto test = [&] { return pruner_.known(node, query_); };
    result_ = {query_.search == nullptr ? test() : query_.search->test_once(node.primitive, test), model::no_index};
    if (result_.known == Containment::depends) add({true, node.complemented, node.op, node.primitive, 0, {}, {}});
    return false;
  }

  /// Takes the result of an operand. Returns false if it decides the operator.
  bool take_result(Visit& visit) {
    const PositiveOperator op = pruner_.tree_.nodes[visit.node].op;
    if (result_.known == (op == PositiveOperator::intersect ? Containment::out : Containment::in)) {
      into_.nodes.resize(visit.first_node);
      return false;
    }
    if (result_.known == Containment::depends) keep(into_, result_.node, op, visit.kept);
    return true;
  }

  void finish(Visit& visit) {
    const PositiveOperator op = pruner_.tree_.nodes[visit.node].op;
    std::vector<std::uint32_t>& kept = visit.kept;
    pruner_.join_leaves(into_, op, kept);
    if (kept.empty()) {
      result_ = {op == PositiveOperator::intersect ? Containment::in : Containment::out, model::no_index};
    } else if (kept.size() == 1) {
      result_ = {Containment::depends, kept.front()};
    } else {
      std::stable_sort(kept.begin(), kept.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return into_.nodes[a].bits > into_.nodes[b].bits; });
      add({false, false, op, model::no_index, bits_needed(into_.nodes, kept), std::move(kept), {}});
    }
  }

  void add(ActiveNode node) {
    result_ = {Containment::depends, static_cast<std::uint32_t>(into_.nodes.size())};
    into_.nodes.push_back(std::move(node));
  }

  const Pruner& pruner_;
  const SurfaceQuery& query_;
  ActiveTree& into_;
  std::vector<Visit> open_;
  Pruned result_;
};

/// Joins the complemented leaves of a union, or the other leaves of an intersection, into one (thesis 7.3.2).
void Pruner::join_leaves(ActiveTree& into, PositiveOperator op, std::vector<std::uint32_t>& operands) const {
  if (!pruning_.sets) return;
  std::optional<std::uint32_t> first;
  std::erase_if(operands, [&](std::uint32_t operand) {
    ActiveNode& node = into.nodes[operand];
    if (!node.is_leaf || node.complemented != (op == PositiveOperator::unite)) return false;
    if (!first) {
      first = operand;
      return false;
    }
    ActiveNode& joined = into.nodes[*first];
    joined.others.push_back(node.primitive);
    joined.others.insert(joined.others.end(), node.others.begin(), node.others.end());
    return true;
  });
}

/// Adds the remaining operands of `node`, an intersection above the set's first primitive. Returns false if the
/// intersection is empty. `meeting`: the primitives below the node that are not disjoint from the block, and the set's
/// first.
bool Pruner::add_operands(std::uint32_t node, Primitives meeting, const SurfaceQuery& query, ActiveTree& into) const {
  const std::uint32_t own = paths_.child_towards(node, query.set.front());
  Traversal walk(*this, query, into);
  while (!meeting.empty()) {
    const std::uint32_t child = paths_.child_towards(node, meeting.front());
    const Primitives some = below(child, meeting);
    meeting = meeting.subspan(some.size());
    if (child == own) continue;
    const Pruned pruned = walk.prune(child, some);
    if (pruned.known == Containment::out) return false;
    if (pruned.known == Containment::depends) keep(into, pruned.node, PositiveOperator::intersect, into.operands);
  }
  return true;
}

ActiveTree Pruner::active_tree(std::span<const std::uint32_t> set, const Block& block) const {
  std::vector<std::uint32_t> found = meeting(set, block);
  SurfaceQuery query{block, set};
  // A traversal without other primitives is faster than a look-up.
  if (kept_ == nullptr || found.empty()) return build_active_tree(query, std::move(found));
  KeptResults::Search search = kept_->search(set, found);
  while (const std::optional<std::uint32_t> primitive = search.next_primitive())
    search.continue_with(known(tree_.nodes[tree_.leaf_of[*primitive]], query));
  const std::uint64_t looked_up = search.visits();
  counted_.add(&isa::Preparation::nodes, looked_up);
  if (const ActiveTree* const tree = search.tree()) {
    search.count_found(looked_up);
    return *tree;
  }
  query.search = &search;
  const std::uint64_t before = visits_;
  ActiveTree active = build_active_tree(query, std::move(found));
  search.keep(active, visits_ - before);
  return active;
}

/// Builds the active tree by a traversal of the CSG tree; `found` are the primitives that meet the block.
ActiveTree Pruner::build_active_tree(const SurfaceQuery& query, std::vector<std::uint32_t> found) const {
  ActiveTree active;
  ActiveTree nothing{true, {}, {}};
  const std::span<const std::uint32_t> set = query.set;
  const std::uint32_t leaf = tree_.leaf_of[set.front()];
  auto begin = found.insert(std::lower_bound(found.begin(), found.end(), set.front()), set.front());
  auto end = begin + 1;
  std::uint32_t at = leaf;
  // Visits, upwards from the leaf, the nodes below which more of the found primitives are.
  while (begin != found.begin() || end != found.end()) {
    visit();
    std::uint32_t node = model::no_index;
    if (begin != found.begin()) node = paths_.common_ancestor(leaf, tree_.leaf_of[*(begin - 1)]);
    if (end != found.end()) node = std::min(node, paths_.common_ancestor(leaf, tree_.leaf_of[*end]));
    begin = std::lower_bound(found.begin(), begin, paths_.first(node));
    end = std::upper_bound(end, found.end(), paths_.last(node));
    if (paths_.is_out_between(at, paths_.child_towards(node, set.front()))) return nothing;
    if (tree_.nodes[node].op == PositiveOperator::intersect) {
      const Primitives meeting(begin, end);
      if (is_decided_elsewhere(node, meeting) || !add_operands(node, meeting, query, active)) return nothing;
    }
    at = node;
  }
  if (paths_.is_out_between(at, tree_.root)) return nothing;
  join_leaves(active, PositiveOperator::intersect, active.operands);
  return active;
}

}  // namespace csgsim::csg
