#include "host/csg/active_tree.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "host/csg/disjoint.h"
#include "host/csg/separation.h"

namespace csgsim::csg {

namespace {

/// Adds a node to the operands of an operator; the operands of one with the same operator instead of it, which is left
/// without any.
void keep(ActiveTree& tree, std::uint32_t index, PositiveOperator op, std::vector<std::uint32_t>& operands) {
  ActiveNode& node = tree.nodes[index];
  if (node.is_leaf || node.op != op) {
    operands.push_back(index);
    return;
  }
  // The fewer go to the more, so that deep trees take no longer than wide ones.
  if (node.children.size() > operands.size()) std::swap(node.children, operands);
  operands.insert(operands.end(), node.children.begin(), node.children.end());
  node.children.clear();
}

/// Narrows the depths to those between the solid's fronts and backs over the block's pixels.
void tighten(Block& block, const view::View& view, const facet::Convex& solid) {
  for (const facet::Halfspace& halfspace : solid.halfspaces) {
    const view::ScreenPlane& plane = view.planes[halfspace.plane];
    if (!plane.representable) continue;
    const view::Side side = view::side_of(plane, halfspace);
    if (side == view::Side::front) {
      block.z_low = std::max(block.z_low, depth_range(plane, view.sampling.fraction_bits, block.pixels).low);
    } else if (side == view::Side::back) {
      block.z_high = std::min(block.z_high, depth_range(plane, view.sampling.fraction_bits, block.pixels).high);
    } else if (locate(view, halfspace, block) == Known::out) {
      block.z_high = block.z_low - 1;
    }
  }
}

/// Results to hold for an operator whose operands need that many, neediest first (Ershov, Sethi and Ullman).
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

struct Pruner::Pruned {
  Known known = Known::depends;
  std::uint32_t node = model::no_index;  ///< in the active tree, if it depends
};

Pruner::Pruner(const facet::Scene& scene, const view::View& view, const PositiveTree& tree, const Pruning& pruning)
    : scene_(scene), view_(view), tree_(tree), pruning_(pruning) {
  subtrees_.resize(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const PositiveNode& node = tree.nodes[i];
    Subtree& subtree = subtrees_[i];
    if (node.is_leaf) {
      const view::Extent& extent = view.extents[node.primitive];
      subtree = {node.complemented, extent.pixels, extent.z_low, extent.z_high, extent.box};
      continue;
    }
    subtree.in_elsewhere = node.op == PositiveOperator::intersect;
    for (const std::uint32_t child : node.children) {
      const Subtree& below = subtrees_[child];
      subtree.in_elsewhere = node.op == PositiveOperator::intersect ? subtree.in_elsewhere && below.in_elsewhere
                                                                    : subtree.in_elsewhere || below.in_elsewhere;
      if (below.pixels.empty()) continue;
      subtree.z_low = subtree.pixels.empty() ? below.z_low : std::min(subtree.z_low, below.z_low);
      subtree.z_high = subtree.pixels.empty() ? below.z_high : std::max(subtree.z_high, below.z_high);
      subtree.pixels = hull(subtree.pixels, below.pixels);
      subtree.box = hull(subtree.box, below.box);
    }
  }
}

Block Pruner::block_of(std::span<const std::uint32_t> set, const view::PixelRect& region) const {
  Block block{region, 0, std::numeric_limits<std::int64_t>::max()};
  for (const std::uint32_t primitive : set) {
    const view::Extent& extent = view_.extents[primitive];
    if (extent.empty()) return {};
    block.pixels = common(block.pixels, extent.pixels);
    block.z_low = std::max(block.z_low, extent.z_low);
    block.z_high = std::min(block.z_high, extent.z_high);
  }
  if (block.pixels.empty() || block.z_low > block.z_high) return {};
  if (pruning_.halfspaces) {
    for (const std::uint32_t primitive : set) tighten(block, view_, scene_.solids[primitive]);
  }
  return block.z_low > block.z_high ? Block{} : block;
}

bool Pruner::disjoint(const Subtree& subtree, const Place& place) const {
  const Block& block = place.block;
  const bool picture =
      common(subtree.pixels, block.pixels).empty() || subtree.z_low > block.z_high || subtree.z_high < block.z_low;
  return (pruning_.picture && picture) ||
         (pruning_.space && std::any_of(place.set.begin(), place.set.end(), [&](std::uint32_t primitive) {
            return csg::disjoint(subtree.box, view_.extents[primitive].box);
          }));
}

/// What is known of a leaf, complemented or not.
Known Pruner::leaf_known(const PositiveNode& leaf, const Place& place) const {
  const Known known = [&] {
    const auto is_separate = [&](std::uint32_t primitive) {
      return separated(view_.extents[leaf.primitive].corners, view_.extents[primitive].corners);
    };
    if (pruning_.separation && std::any_of(place.set.begin(), place.set.end(), is_separate)) return Known::out;
    return pruning_.halfspaces ? locate(view_, scene_, leaf.primitive, place.block) : Known::depends;
  }();
  if (known == Known::depends || !leaf.complemented) return known;
  return known == Known::in ? Known::out : Known::in;
}

Pruner::Pruned Pruner::prune(std::uint32_t root, const Place& place, ActiveTree& into) const {
  // One for each node on the way down; no tree is too deep for it.
  struct Visit {
    std::uint32_t node;
    std::size_t next = 0;
    std::vector<std::uint32_t> kept{};
  };
  std::vector<Visit> path{{root}};
  Pruned result;
  const auto decided = [&](std::uint32_t index) -> Known {
    const Subtree& subtree = subtrees_[index];
    if (disjoint(subtree, place)) return subtree.in_elsewhere ? Known::in : Known::out;
    const PositiveNode& node = tree_.nodes[index];
    if (!node.is_leaf) return Known::depends;
    const bool in_set = std::binary_search(place.set.begin(), place.set.end(), node.primitive);
    return in_set ? Known::in : leaf_known(node, place);
  };
  while (!path.empty()) {
    Visit& visit = path.back();
    const PositiveNode& node = tree_.nodes[visit.node];
    if (visit.next == 0) {
      result = {decided(visit.node), model::no_index};
      if (result.known != Known::depends || node.is_leaf) {
        if (result.known == Known::depends) {
          result.node = static_cast<std::uint32_t>(into.nodes.size());
          into.nodes.push_back({true, node.complemented, node.op, node.primitive, 0, {}, {}});
        }
        path.pop_back();
        continue;
      }
    } else {
      // The child before has come back with `result`.
      const Known dominant = node.op == PositiveOperator::intersect ? Known::out : Known::in;
      if (result.known == dominant) {
        path.pop_back();
        continue;
      }
      if (result.known == Known::depends) keep(into, result.node, node.op, visit.kept);
    }
    if (visit.next < node.children.size()) {
      const std::uint32_t child = node.children[visit.next++];
      path.push_back({child});
      continue;
    }
    join_leaves(into, node.op, visit.kept);
    if (visit.kept.empty()) {
      result = {node.op == PositiveOperator::intersect ? Known::in : Known::out, model::no_index};
    } else if (visit.kept.size() == 1) {
      result = {Known::depends, visit.kept.front()};
    } else {
      std::stable_sort(visit.kept.begin(), visit.kept.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return into.nodes[a].bits > into.nodes[b].bits; });
      const std::uint32_t bits = bits_needed(into.nodes, visit.kept);
      result = {Known::depends, static_cast<std::uint32_t>(into.nodes.size())};
      into.nodes.push_back({false, false, node.op, model::no_index, bits, std::move(visit.kept), {}});
    }
    path.pop_back();
  }
  return result;
}

/// Complemented leaves of a union, and others of an intersection, become one (thesis 7.3.2).
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

ActiveTree Pruner::active_tree(std::span<const std::uint32_t> set, const Block& block) const {
  ActiveTree active;
  const Place place{block, set};
  std::uint32_t below = tree_.leaf_of[set.front()];
  for (std::uint32_t at = tree_.nodes[below].parent; at != model::no_index; below = at, at = tree_.nodes[at].parent) {
    if (tree_.nodes[at].op != PositiveOperator::intersect) continue;
    for (const std::uint32_t sibling : tree_.nodes[at].children) {
      if (sibling == below) continue;
      const Pruned pruned = prune(sibling, place, active);
      if (pruned.known == Known::out) {
        active = {};
        active.nothing = true;
        return active;
      }
      if (pruned.known == Known::depends) keep(active, pruned.node, PositiveOperator::intersect, active.operands);
    }
  }
  join_leaves(active, PositiveOperator::intersect, active.operands);
  return active;
}

}  // namespace csgsim::csg
