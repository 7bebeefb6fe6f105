#include "host/csg/active_tree.h"

#include <algorithm>

namespace csgsim::csg {

namespace {

bool boxes_apart(const facet::Box& a, const facet::Box& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis]) return true;
  }
  return false;
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

struct Pruner::Pruned {
  Known known = Known::depends;
  std::uint32_t node = model::no_index;  ///< in the active tree, if it depends
};

Pruner::Pruner(const facet::Scene& scene, const view::View& view, const PositiveTree& tree,
               const view::PixelRect& region)
    : scene_(scene), view_(view), tree_(tree), region_(region) {
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

Block Pruner::block_of(std::uint32_t primitive) const {
  const view::Extent& extent = view_.extents[primitive];
  if (extent.empty()) return {};
  return {common(extent.pixels, region_), extent.z_low, extent.z_high};
}

bool Pruner::apart(const Subtree& subtree, const Block& block, const facet::Box& box) const {
  return common(subtree.pixels, block.pixels).empty() || subtree.z_low > block.z_high || subtree.z_high < block.z_low ||
         boxes_apart(subtree.box, box);
}

Pruner::Pruned Pruner::prune(std::uint32_t root, const Block& block, const facet::Box& box, ActiveTree& into) const {
  // A frame a node on the way down; no tree is too deep for it.
  struct Frame {
    std::uint32_t node;
    std::size_t next = 0;
    std::vector<std::uint32_t> kept{};
  };
  std::vector<Frame> path{{root}};
  Pruned result;
  const auto decided = [&](std::uint32_t index) -> Known {
    const Subtree& subtree = subtrees_[index];
    if (apart(subtree, block, box)) return subtree.in_elsewhere ? Known::in : Known::out;
    const PositiveNode& node = tree_.nodes[index];
    if (!node.is_leaf) return Known::depends;
    const Known known = locate(view_, scene_, node.primitive, block);
    if (known == Known::depends || !node.complemented) return known;
    return known == Known::in ? Known::out : Known::in;
  };
  while (!path.empty()) {
    Frame& frame = path.back();
    const PositiveNode& node = tree_.nodes[frame.node];
    if (frame.next == 0) {
      result = {decided(frame.node), model::no_index};
      if (result.known != Known::depends || node.is_leaf) {
        if (result.known == Known::depends) {
          result.node = static_cast<std::uint32_t>(into.nodes.size());
          into.nodes.push_back({true, node.complemented, node.op, node.primitive, 0, {}});
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
      if (result.known == Known::depends) frame.kept.push_back(result.node);
    }
    if (frame.next < node.children.size()) {
      const std::uint32_t child = node.children[frame.next++];
      path.push_back({child});
      continue;
    }
    if (frame.kept.empty()) {
      result = {node.op == PositiveOperator::intersect ? Known::in : Known::out, model::no_index};
    } else if (frame.kept.size() == 1) {
      result = {Known::depends, frame.kept.front()};
    } else {
      std::stable_sort(frame.kept.begin(), frame.kept.end(),
                       [&](std::uint32_t a, std::uint32_t b) { return into.nodes[a].bits > into.nodes[b].bits; });
      const std::uint32_t bits = bits_needed(into.nodes, frame.kept);
      result = {Known::depends, static_cast<std::uint32_t>(into.nodes.size())};
      into.nodes.push_back({false, false, node.op, model::no_index, bits, std::move(frame.kept)});
    }
    path.pop_back();
  }
  return result;
}

ActiveTree Pruner::active_tree(std::uint32_t primitive) const {
  ActiveTree active;
  const Block block = block_of(primitive);
  if (block.pixels.empty()) {
    active.nothing = true;
    return active;
  }
  const facet::Box& box = view_.extents[primitive].box;
  std::uint32_t below = tree_.leaf_of[primitive];
  for (std::uint32_t at = tree_.nodes[below].parent; at != model::no_index; below = at, at = tree_.nodes[at].parent) {
    if (tree_.nodes[at].op != PositiveOperator::intersect) continue;
    for (const std::uint32_t sibling : tree_.nodes[at].children) {
      if (sibling == below) continue;
      const Pruned pruned = prune(sibling, block, box, active);
      if (pruned.known == Known::out) {
        active = {};
        active.nothing = true;
        return active;
      }
      if (pruned.known == Known::depends) active.operands.push_back(pruned.node);
    }
  }
  return active;
}

}  // namespace csgsim::csg
