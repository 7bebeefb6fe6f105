#pragma once

#include <cstdint>
#include <vector>

#include "hw/division/display_model.h"

namespace csgsim::division {

inline constexpr std::uint32_t no_node = 0xffffffffU;

/// A node of the divider's tree, computed once as the nodes are received.
struct TreeNode {
  bool is_leaf = false;
  Operator op = Operator::unite;
  std::uint32_t primitive = 0;  ///< primitive of a leaf
  std::uint32_t parent = no_node;
  std::uint32_t first = 0;  ///< the nodes [first, own index] form the subtree
  std::vector<std::uint32_t> operands;
  Box box;  ///< encloses the boxes of all primitives of the subtree that have pixels
  /// Whether a point outside all primitives of the subtree is inside the solid that the subtree represents.
  bool is_inside_elsewhere = false;
};

struct Tree {
  std::vector<TreeNode> nodes;         ///< nodes in postorder
  std::vector<std::uint32_t> leaf_of;  ///< leaf of each primitive
};

/// The model must be valid.
Tree make_tree(const DisplayModel& model);

}  // namespace csgsim::division
