#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/display_model.h"

namespace csgsim::division {

inline constexpr std::uint32_t no_node = 0xffffffffU;

/// A node of the tree as the divider keeps it, worked out once, as the nodes arrive.
struct TreeNode {
  bool is_leaf = false;
  Operator op = Operator::unite;
  std::uint32_t primitive = 0;  ///< of a leaf
  std::uint32_t parent = no_node;
  std::uint32_t first = 0;  ///< the nodes [first, own index] are the subtree
  std::vector<std::uint32_t> operands;
  Box box;                    ///< holds the boxes of all primitives of the subtree that have pixels
  bool in_elsewhere = false;  ///< what the subtree is where none of its primitives is
};

struct Tree {
  std::vector<TreeNode> nodes;         ///< in postorder
  std::vector<std::uint32_t> leaf_of;  ///< one a primitive
};

/// Of a sound model.
Tree make_tree(const DisplayModel& model);

}  // namespace csgsim::division
