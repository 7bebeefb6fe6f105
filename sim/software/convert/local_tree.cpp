#include "sim/software/convert/local_tree.h"

#include <algorithm>
#include <functional>

namespace csgsim::software::convert {

namespace {

using Node = LocalTree::Node;
using Kind = Node::Kind;

/// Combined value of an operator's operands.
struct Sum {
  SideValues value{};      ///< value of the known operands
  std::uint32_t open = 0;  ///< number of unknown operands
};

/// The value that decides an operator regardless of its other operands.
bool deciding(Kind kind) { return kind == Kind::unite; }

SideValues identity_of(Kind kind) { return {!deciding(kind), !deciding(kind)}; }

bool is_decided(Kind kind, const SideValues& value) {
  return value.behind == deciding(kind) && value.before == deciding(kind);
}

void combine(Kind kind, SideValues& sum, const SideValues& value) {
  if (kind == Kind::unite) {
    sum = {sum.behind || value.behind, sum.before || value.before};
  } else {
    sum = {sum.behind && value.behind, sum.before && value.before};
  }
}

SideValues complement(const SideValues& value) { return {!value.behind, !value.before}; }

Kind kind_of(csg::PositiveOperator op) { return op == csg::PositiveOperator::unite ? Kind::unite : Kind::intersect; }

bool is_operator(const Node& node) { return node.kind == Kind::unite || node.kind == Kind::intersect; }

/// Nodes of the tree at or above the leaves of the primitives, ascending: children precede their parents.
std::vector<std::uint32_t> nodes_above(const csg::PositiveTree& tree, std::span<const std::uint32_t> primitives) {
  std::vector<std::uint32_t> open;
  for (const std::uint32_t primitive : primitives) open.push_back(tree.leaf_of[primitive]);
  std::vector<std::uint32_t> found;
  std::ranges::make_heap(open, std::greater<>());
  while (!open.empty()) {
    std::ranges::pop_heap(open, std::greater<>());
    const std::uint32_t node = open.back();
    open.pop_back();
    if (!found.empty() && found.back() == node) continue;
    found.push_back(node);
    if (tree.nodes[node].parent == model::no_index) continue;
    open.push_back(tree.nodes[node].parent);
    std::ranges::push_heap(open, std::greater<>());
  }
  return found;
}

}  // namespace

LocalTree::LocalTree(const csg::PositiveTree& tree, const csg::TreePaths& paths,
                     std::span<const std::uint32_t> primitives) {
  const std::vector<std::uint32_t> above = nodes_above(tree, primitives);
  const auto number_of = [&](std::uint32_t node) {
    return static_cast<std::uint32_t>(std::ranges::lower_bound(above, node) - above.begin());
  };
  // By node: number of operands in `above` whose value outside all primitives decides the node.
  std::vector<std::uint32_t> deciding_elsewhere(above.size(), 0);
  for (const std::uint32_t index : above) {
    const csg::PositiveNode& node = tree.nodes[index];
    Node local{.kind = node.is_leaf ? Kind::leaf : kind_of(node.op), .complemented = node.complemented};
    if (node.is_leaf)
      local.operand =
          static_cast<std::uint32_t>(std::ranges::lower_bound(primitives, node.primitive) - primitives.begin());
    if (node.parent != model::no_index) {
      local.parent = number_of(node.parent);
      if (paths.decides_elsewhere(index)) ++deciding_elsewhere[local.parent];
    }
    nodes_.push_back(local);
  }
  for (std::size_t i = 0; i < above.size(); ++i) {
    if (!is_operator(nodes_[i]) || paths.deciding_children(above[i]) == deciding_elsewhere[i]) continue;
    // An operand without any of the primitives decides this node.
    nodes_[i] = {.kind = Kind::constant,
                 .value = complement(identity_of(nodes_[i].kind)),
                 .operand = 0,
                 .parent = nodes_[i].parent};
  }
}

void LocalTree::renumber(std::span<const std::uint32_t> numbers) {
  for (Node& node : nodes_)
    if (node.kind == Kind::leaf) node.operand = numbers[node.operand];
}

LocalTree LocalTree::reduced(std::span<const Known> operands, const std::vector<bool>& may_differ) const {
  LocalTree result;
  if (value_.is_known) {
    result.value_ = value_;
    return result;
  }
  const std::size_t count = nodes_.size();
  std::vector<Sum> sums(count);
  std::vector<bool> is_open(count, false);
  for (std::size_t i = 0; i < count; ++i)
    if (is_operator(nodes_[i])) sums[i].value = identity_of(nodes_[i].kind);
  for (std::size_t i = 0; i < count; ++i) {
    const Node& node = nodes_[i];
    Known known;
    if (node.kind == Kind::constant) {
      known = {true, node.value};
    } else if (node.kind == Kind::leaf) {
      known = operands[node.operand];
      if (node.complemented) known.value = complement(known.value);
    } else {
      known = {sums[i].open == 0 || is_decided(node.kind, sums[i].value), sums[i].value};
    }
    is_open[i] = !known.is_known;
    if (node.parent == none) {
      result.value_ = known;
      if (known.is_known) return result;
      continue;
    }
    const Node& parent = nodes_[node.parent];
    if (!is_operator(parent)) continue;
    if (known.is_known) {
      combine(parent.kind, sums[node.parent].value, known.value);
    } else {
      ++sums[node.parent].open;
    }
  }
  // Proceeding from the root, determine the remaining nodes; nodes with a single open operand and no other effect are
  // replaced by that operand.
  std::vector<std::uint32_t> stands_for(count, none);  // the node that becomes the parent of this one's operands
  std::vector<bool> is_left(count, false);
  for (std::size_t i = count; i-- > 0;) {
    const Node& node = nodes_[i];
    const bool is_root = node.parent == none;
    if (!is_open[i] || !(is_root || is_left[node.parent])) continue;
    is_left[i] = true;
    const bool is_passed = is_operator(node) && sums[i].open == 1 && sums[i].value == identity_of(node.kind);
    stands_for[i] = !is_passed ? static_cast<std::uint32_t>(i) : is_root ? none : stands_for[node.parent];
  }
  std::vector<std::uint32_t> places(count, none);
  std::vector<Node>& left = result.nodes_;
  result.may_differ_ = false;
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_left[i] || stands_for[i] != i) continue;
    Node node = nodes_[i];
    node.parent = node.parent == none ? none : stands_for[node.parent];
    if (is_operator(node) && !(sums[i].value == identity_of(node.kind))) {
      left.push_back({.kind = Kind::constant, .value = sums[i].value, .parent = static_cast<std::uint32_t>(i)});
      result.may_differ_ = true;
    }
    if (node.kind == Kind::leaf && may_differ[node.operand]) result.may_differ_ = true;
    places[i] = static_cast<std::uint32_t>(left.size());
    left.push_back(node);
  }
  for (Node& node : left)
    if (node.parent != none) node.parent = places[node.parent];
  return result;
}

}  // namespace csgsim::software::convert
