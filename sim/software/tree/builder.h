// Construction of binary CSG trees.
// Used by tree.cpp and reduced.cpp.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Builds a tree bottom-up: children are added before their parents.
class Builder {
 public:
  explicit Builder(std::size_t primitives) { tree_.leaf_of.assign(primitives, model::no_index); }

  std::uint32_t leaf(std::uint32_t primitive) {
    tree_.leaf_of[primitive] = next();
    tree_.nodes.push_back({.is_leaf = true, .primitive = primitive});
    return next() - 1;
  }

  std::uint32_t join(model::Operator op, std::uint32_t left, std::uint32_t right) {
    const std::uint32_t height = 1 + std::max(tree_.nodes[left].height, tree_.nodes[right].height);
    tree_.nodes[left].parent = next();
    tree_.nodes[right].parent = next();
    tree_.nodes.push_back({.op = op, .left = left, .right = right, .height = height});
    return next() - 1;
  }

  [[nodiscard]] std::uint32_t height(std::uint32_t node) const { return tree_.nodes[node].height; }

  Tree take_tree(std::uint32_t root) {
    tree_.root = root;
    return std::move(tree_);
  }

 private:
  [[nodiscard]] std::uint32_t next() const { return static_cast<std::uint32_t>(tree_.nodes.size()); }

  Tree tree_;
};

}  // namespace csgsim::software
