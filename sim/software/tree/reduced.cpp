#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "sim/software/tree/builder.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

namespace {

/// Result of reducing a node: a constant, or a node of the new tree or its complement.
struct Rest {
  Known known = Known::nothing;
  std::uint32_t node = model::no_index;
  bool complemented = false;
};

Rest complement(const Rest& rest) {
  switch (rest.known) {
    case Known::in: return {Known::out};
    case Known::out: return {Known::in};
    case Known::nothing: break;
  }
  return {Known::nothing, rest.node, !rest.complemented};
}

/// Intersection of two non-constant operands by de Morgan's laws.
Rest intersected(Builder& builder, const Rest& a, const Rest& b) {
  using model::Operator;
  if (a.complemented && b.complemented) return {Known::nothing, builder.join(Operator::unite, a.node, b.node), true};
  if (a.complemented) return {Known::nothing, builder.join(Operator::subtract, b.node, a.node)};
  if (b.complemented) return {Known::nothing, builder.join(Operator::subtract, a.node, b.node)};
  return {Known::nothing, builder.join(Operator::intersect, a.node, b.node)};
}

Rest both(Builder& builder, const Rest& a, const Rest& b) {
  if (a.known == Known::out || b.known == Known::out) return {Known::out};
  if (a.known == Known::in) return b;
  if (b.known == Known::in) return a;
  return intersected(builder, a, b);
}

Rest either(Builder& builder, const Rest& a, const Rest& b) {
  const bool is_plain = a.known == Known::nothing && b.known == Known::nothing && !a.complemented && !b.complemented;
  if (is_plain) return {Known::nothing, builder.join(model::Operator::unite, a.node, b.node)};
  return complement(both(builder, complement(a), complement(b)));
}

Rest combined(Builder& builder, model::Operator op, const Rest& a, const Rest& b) {
  switch (op) {
    case model::Operator::unite: return either(builder, a, b);
    case model::Operator::intersect: return both(builder, a, b);
    case model::Operator::subtract: break;
  }
  return both(builder, a, complement(b));
}

/// Copies the nodes below the root, dropping those that became unused.
Tree gathered(const Tree& made, std::uint32_t root) {
  std::vector<bool> is_used(made.nodes.size());
  is_used[root] = true;
  for (std::size_t i = root + std::size_t{1}; i-- > 0;) {
    if (!is_used[i] || made.nodes[i].is_leaf) continue;
    is_used[made.nodes[i].left] = true;
    is_used[made.nodes[i].right] = true;
  }
  Builder builder(made.leaf_of.size());
  std::vector<std::uint32_t> place(made.nodes.size());
  for (std::size_t i = 0; i <= root; ++i) {
    if (!is_used[i]) continue;
    const Node& node = made.nodes[i];
    place[i] = node.is_leaf ? builder.leaf(node.primitive) : builder.join(node.op, place[node.left], place[node.right]);
  }
  return builder.take_tree(place[root]);
}

}  // namespace

Tree reduced(const Tree& tree, std::span<const Known> known) {
  Tree none;
  none.leaf_of.assign(tree.leaf_of.size(), model::no_index);
  none.complemented = tree.complemented;
  if (tree.is_constant()) return none;
  Builder builder(tree.leaf_of.size());
  std::vector<Rest> rests;
  rests.reserve(tree.nodes.size());
  for (const Node& node : tree.nodes) {
    if (!node.is_leaf) {
      rests.push_back(combined(builder, node.op, rests[node.left], rests[node.right]));
    } else if (known[node.primitive] != Known::nothing) {
      rests.push_back({known[node.primitive]});
    } else {
      rests.push_back({Known::nothing, builder.leaf(node.primitive)});
    }
  }
  const Rest& root = rests[tree.root];
  if (root.known != Known::nothing) {
    none.complemented = tree.complemented != (root.known == Known::in);
    return none;
  }
  Tree rest = gathered(builder.take_tree(root.node), root.node);
  rest.complemented = tree.complemented != root.complemented;
  return rest;
}

}  // namespace csgsim::software
