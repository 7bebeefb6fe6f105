#pragma once

#include <rapidcheck.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

#include "host/csg/active_tree.h"

namespace csgsim::testing {

using csg::ActiveTree;
using csg::PositiveOperator;

// Primitives are numbered from left to right and occur in one leaf each.

inline std::uint32_t add_leaf(ActiveTree& tree, std::uint32_t primitive, bool complemented = false) {
  tree.nodes.push_back({true, complemented, PositiveOperator::unite, primitive, 0, {}, {}});
  return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

inline std::uint32_t add_operator(ActiveTree& tree, PositiveOperator op, std::vector<std::uint32_t> children) {
  tree.nodes.push_back({false, false, op, model::no_index, 0, std::move(children), {}});
  return static_cast<std::uint32_t>(tree.nodes.size() - 1);
}

inline PositiveOperator other(PositiveOperator op) {
  return op == PositiveOperator::unite ? PositiveOperator::intersect : PositiveOperator::unite;
}

inline std::size_t leaves_of(const ActiveTree& tree) {
  return static_cast<std::size_t>(std::ranges::count(tree.nodes, true, &csg::ActiveNode::is_leaf));
}

/// Reads a subtree: a leaf is ".", an operator "+(...)" or "*(...)".
inline std::uint32_t add_text(ActiveTree& tree, std::string_view& text) {
  const char first = text.front();
  text.remove_prefix(1);
  if (first == '.') return add_leaf(tree, static_cast<std::uint32_t>(leaves_of(tree)));
  std::vector<std::uint32_t> children;
  for (text.remove_prefix(1); text.front() != ')';) children.push_back(add_text(tree, text));
  text.remove_prefix(1);
  return add_operator(tree, first == '+' ? PositiveOperator::unite : PositiveOperator::intersect, std::move(children));
}

/// Whether an operator may have operands with the same operator.
enum class Nesting : std::uint8_t { alternating, any };

class RandomTree {
 public:
  RandomTree(std::uint64_t seed, Nesting nesting) : engine_(seed), nesting_(nesting) {}

  ActiveTree make(std::uint32_t leaves) {
    tree_.operands = split(leaves, 1 + below(std::min(leaves, 3U)), PositiveOperator::intersect);
    return std::move(tree_);
  }

 private:
  std::uint32_t below(std::uint32_t limit) { return static_cast<std::uint32_t>(engine_() % limit); }

  std::uint32_t subtree(std::uint32_t leaves, PositiveOperator op) {
    if (leaves == 1) return add_leaf(tree_, primitives_++, below(2) == 1);
    const std::uint32_t parts = std::min(leaves, 2 + (below(3) == 0 ? below(4) : 0));
    return add_operator(tree_, op, split(leaves, parts, op));
  }

  /// The operands of an operator.
  std::vector<std::uint32_t> split(std::uint32_t leaves, std::uint32_t parts, PositiveOperator op) {
    std::vector<std::uint32_t> result;
    for (std::uint32_t after = parts; after-- > 0;) {
      const std::uint32_t most = leaves - after;
      const std::uint32_t share = after == 0 ? most : below(2) == 1 ? 1 + below(most) : (most + 1) / 2;
      const bool same = nesting_ == Nesting::any && below(2) == 1;
      result.push_back(subtree(share, same ? op : other(op)));
      leaves -= share;
    }
    return result;
  }

  std::mt19937_64 engine_;
  Nesting nesting_;
  ActiveTree tree_;
  std::uint32_t primitives_ = 0;
};

/// A tree with a seed from rapidcheck.
inline ActiveTree any_tree(std::uint32_t most_leaves, Nesting nesting = Nesting::any) {
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();
  return RandomTree(seed, nesting).make(*rc::gen::inRange<std::uint32_t>(1, most_leaves + 1));
}

inline bool evaluate(const ActiveTree& tree, const std::vector<bool>& in) {
  std::vector<bool> value(tree.nodes.size());
  for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
    const csg::ActiveNode& node = tree.nodes[i];
    const auto is_in = [&](std::uint32_t child) { return value[child]; };
    if (node.is_leaf) {
      const bool inside =
          in[node.primitive] && std::ranges::all_of(node.others, [&](std::uint32_t other) { return in[other]; });
      value[i] = inside != node.complemented;
    } else {
      value[i] = node.op == PositiveOperator::intersect ? std::ranges::all_of(node.children, is_in)
                                                        : std::ranges::any_of(node.children, is_in);
    }
  }
  return std::ranges::all_of(tree.operands, [&](std::uint32_t operand) { return value[operand]; });
}

// Every positive expression over n different leaves is a tree of alternating operators.

struct Shape {
  std::uint32_t leaves = 1;
  std::vector<std::size_t> children{};  ///< indices of shapes in ascending order
};

/// Appends the shapes with `missing` more leaves than `begun` and further children from index `from`.
inline void append_shapes(std::vector<Shape>& shapes, const Shape& begun, std::uint32_t missing, std::size_t from,
                          std::size_t smaller) {
  if (missing == 0) shapes.push_back(begun);
  for (std::size_t i = from; i < smaller && shapes[i].leaves <= missing; ++i) {
    Shape longer = begun;
    longer.children.push_back(i);
    append_shapes(shapes, longer, missing - shapes[i].leaves, i, smaller);
  }
}

/// Every tree of operators with at least two children, regardless of the order of children; sorted by number of leaves.
inline std::vector<Shape> all_shapes(std::uint32_t most_leaves) {
  std::vector<Shape> shapes{{}};
  for (std::uint32_t leaves = 2; leaves <= most_leaves; ++leaves) {
    append_shapes(shapes, {leaves, {}}, leaves, 0, shapes.size());
  }
  return shapes;
}

inline std::uint32_t add_shape(ActiveTree& tree, const std::vector<Shape>& shapes, std::size_t shape,
                               PositiveOperator op, std::uint32_t& primitives) {
  if (shapes[shape].children.empty()) {
    const std::uint32_t primitive = primitives++;
    return add_leaf(tree, primitive, primitive % 3 == 1);
  }
  std::vector<std::uint32_t> children;
  for (const std::size_t child : shapes[shape].children) {
    children.push_back(add_shape(tree, shapes, child, other(op), primitives));
  }
  return add_operator(tree, op, children);
}

inline ActiveTree tree_of(const std::vector<Shape>& shapes, std::size_t shape, PositiveOperator op) {
  ActiveTree tree;
  std::uint32_t primitives = 0;
  tree.operands = {add_shape(tree, shapes, shape, op, primitives)};
  return tree;
}

template <typename Check>
inline void for_all_trees(std::uint32_t most_leaves, const Check& check) {
  const std::vector<Shape> shapes = all_shapes(most_leaves);
  for (std::size_t shape = 0; shape < shapes.size(); ++shape) {
    check(tree_of(shapes, shape, PositiveOperator::unite), shapes[shape].leaves);
    check(tree_of(shapes, shape, PositiveOperator::intersect), shapes[shape].leaves);
  }
}

/// The smallest tree with this footprint, with 3 * 2^(labels - 2) - 2 leaves: twice the previous one and a leaf, under
/// two levels of operators.
inline ActiveTree widest_tree(std::uint32_t labels) {
  std::vector<Shape> shapes{{}};
  for (std::uint32_t i = 2; i < labels; ++i) {
    const std::size_t before = shapes.size() - 1;
    shapes.push_back({1 + shapes[before].leaves, {0, before}});
    shapes.push_back({2 + 2 * shapes[before].leaves, {before + 1, before + 1}});
  }
  return tree_of(shapes, shapes.size() - 1, PositiveOperator::intersect);
}

/// The union of a tree with one more leaf, which makes the tree's FALSE need a label.
inline ActiveTree under_a_union(ActiveTree tree) {
  std::vector<std::uint32_t> children = std::move(tree.operands);
  children.push_back(add_leaf(tree, static_cast<std::uint32_t>(leaves_of(tree))));
  tree.operands = {add_operator(tree, PositiveOperator::unite, std::move(children))};
  return tree;
}

}  // namespace csgsim::testing
