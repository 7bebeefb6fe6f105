// CSG trees in positive form: only unions, intersections and complemented leaves.
// Used by host/convex, host/emit, host/setup, host/solids, sim/software, sim/story and sim/studies.
#pragma once

#include <cstdint>
#include <vector>

#include "host/model/tree.h"

namespace csgsim::csg {

enum class PositiveOperator : std::uint8_t { unite, intersect };

/// A node of the positive form: only unions and intersections; leaves may be complemented.
struct PositiveNode {
  bool is_leaf = false;
  bool complemented = false;  ///< leaf: the space outside its primitive
  PositiveOperator op = PositiveOperator::unite;
  std::uint32_t primitive = model::no_index;
  std::uint32_t parent = model::no_index;
  std::vector<std::uint32_t> children;
};

/// A CSG tree in positive form (thesis 6.2): A - B becomes A and not B, and de Morgan's laws push complements to the
/// leaves. Nodes have the indices of the original tree, children before parents.
struct PositiveTree {
  std::vector<PositiveNode> nodes;
  std::uint32_t root = model::no_index;
  std::vector<std::uint32_t> leaf_of;  ///< the leaf node of each primitive
};

PositiveTree make_positive_tree(const model::Tree& tree);

}  // namespace csgsim::csg
