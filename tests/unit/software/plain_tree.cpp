#include "tests/unit/software/plain_tree.h"

#include <algorithm>
#include <cstddef>

namespace csgsim::testing {

namespace {

using model::Operator;

bool combined(Operator op, bool left, bool right) {
  if (op == Operator::unite) return left || right;
  if (op == Operator::intersect) return left && right;
  return left && !right;
}

/// Returns the result if the left operand alone decides it.
std::optional<bool> by_left(Operator op, bool left) {
  if (combined(op, left, false) == combined(op, left, true)) return combined(op, left, false);
  return std::nullopt;
}

}  // namespace

PlainTree::PlainTree(const model::Tree& tree) : leaf_of_(tree.primitives.size()) { root_ = add(tree, tree.root); }

std::uint32_t PlainTree::add(const model::Tree& tree, std::uint32_t node) {
  const model::Node& from = tree.nodes[node];
  if (from.is_leaf) {
    leaf_of_[from.primitive] = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.primitive = from.primitive});
    return leaf_of_[from.primitive];
  }
  std::uint32_t left = add(tree, from.children.front());
  for (std::size_t i = 1; i < from.children.size(); ++i) {
    const std::uint32_t right = add(tree, from.children[i]);
    const auto made = static_cast<std::uint32_t>(nodes_.size());
    nodes_.push_back({.op = from.op, .left = left, .right = right});
    nodes_[left].parent = made;
    nodes_[right].parent = made;
    left = made;
  }
  return left;
}

std::uint64_t PlainTree::levels(std::uint32_t node) const {
  if (!nodes_[node].op) return 0;
  return 1 + std::max(levels(nodes_[node].left), levels(nodes_[node].right));
}

bool PlainTree::holds(std::uint32_t node, const Held& held) const {
  const Node& here = nodes_[node];
  return here.op ? combined(*here.op, holds(here.left, held), holds(here.right, held)) : held[here.primitive];
}

bool PlainTree::has_any(std::uint32_t node, const Held& held) const {
  const Node& here = nodes_[node];
  return here.op ? has_any(here.left, held) || has_any(here.right, held) : held[here.primitive];
}

std::uint64_t PlainTree::nodes_with(std::uint32_t node, const Held& there) const {
  const Node& here = nodes_[node];
  if (!here.op) return there[here.primitive] ? 1 : 0;
  const std::uint64_t left = nodes_with(here.left, there);
  const std::uint64_t right = nodes_with(here.right, there);
  if (left > 0 && right > 0) return left + right + 1;
  return *here.op == Operator::unite ? left + right : *here.op == Operator::subtract ? left : 0;
}

bool PlainTree::is_on_odd_side(std::uint32_t node) const {
  bool is_odd = false;
  for (std::uint32_t at = node; nodes_[at].parent != none; at = nodes_[at].parent) {
    const Node& parent = nodes_[nodes_[at].parent];
    if (parent.op == Operator::subtract && parent.right == at) is_odd = !is_odd;
  }
  return is_odd;
}

bool PlainTree::is_subtracted(std::uint32_t primitive) const { return is_on_odd_side(leaf_of_[primitive]); }

bool PlainTree::early_out(std::uint32_t node, const Held& held, TreeVisits& tally) const {
  const Node& here = nodes_[node];
  ++tally.visits;
  if (!here.op) return held[here.primitive];
  const bool left = early_out(here.left, held, tally);
  if (const std::optional<bool> decided = by_left(*here.op, left)) {
    ++tally.early_outs;
    return *decided;
  }
  return combined(*here.op, left, early_out(here.right, held, tally));
}

TreeVisits PlainTree::early_out(const Held& held) const {
  TreeVisits tally;
  early_out(root_, held, tally);
  return tally;
}

bool PlainTree::positional(std::uint32_t node, const Held& held, TreeVisits& tally) const {
  if (!has_any(node, held)) return false;
  const Node& here = nodes_[node];
  ++tally.visits;
  if (!here.op) return true;
  const bool left = positional(here.left, held, tally);
  if (const std::optional<bool> decided = by_left(*here.op, left)) {
    tally.early_outs += has_any(here.right, held) ? 1U : 0U;
    return *decided;
  }
  return combined(*here.op, left, positional(here.right, held, tally));
}

TreeVisits PlainTree::positional(const Held& held) const {
  TreeVisits tally;
  positional(root_, held, tally);
  return tally;
}

TreeVisits PlainTree::update_tree(Held& held, std::uint32_t primitive) const {
  const Held before = held;
  held[primitive] = !held[primitive];
  TreeVisits tally{1};
  for (std::uint32_t at = nodes_[leaf_of_[primitive]].parent; at != none; at = nodes_[at].parent) {
    ++tally.visits;
    tally.differences += nodes_[at].op == Operator::subtract ? 1U : 0U;
    if (holds(at, before) == holds(at, held)) {
      ++tally.early_outs;
      break;
    }
  }
  return tally;
}

bool PlainTree::shows(const Held& held, std::uint32_t primitive, TreeVisits& tally) const {
  for (std::uint32_t at = leaf_of_[primitive]; nodes_[at].parent != none; at = nodes_[at].parent) {
    const Node& parent = nodes_[nodes_[at].parent];
    const bool is_right = parent.right == at;
    const std::uint32_t other = is_right ? parent.left : parent.right;
    ++tally.visits;
    // Relative to the root a subtracted solid is inside out, and so are unions and intersections in it.
    const bool is_odd = is_on_odd_side(nodes_[at].parent);
    const bool widens = (parent.op == Operator::unite) != is_odd;
    if (!widens && holds(other, held) == is_on_odd_side(other)) return false;
  }
  return true;
}

}  // namespace csgsim::testing
