#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace csgsim::m68000 {

/// Kinds of nodes, with the numbers that the programs use.
enum class NodeKind : std::uint16_t { primitive, set_union, difference, intersection };

struct TreeNode {
  NodeKind kind = NodeKind::primitive;
  std::uint16_t primitive = 0;  ///< number of a leaf's primitive, from 0; every primitive has one leaf
  std::size_t left = 0;         ///< index of the left child of an inner node
  std::size_t right = 0;
};

/// A tree of at most 1024 primitives.
struct Tree {
  std::vector<TreeNode> nodes;
  std::size_t root = 0;
};

}  // namespace csgsim::m68000
