#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace csgsim::m68000 {

/// What a node is; programs have the same numbers.
enum class NodeKind : std::uint16_t { primitive, set_union, difference, intersection };

struct TreeNode {
  NodeKind kind = NodeKind::primitive;
  std::uint16_t primitive = 0;  ///< number of a leaf's, from 0; every primitive has one leaf
  std::size_t left = 0;         ///< index of the node, of one that is no leaf
  std::size_t right = 0;
};

/// Of 1024 primitives at most.
struct Tree {
  std::vector<TreeNode> nodes;
  std::size_t root = 0;
};

}  // namespace csgsim::m68000
