// Prunes CSG trees and counts the operations of pruning.
// Used by evaluations.h and by interval arithmetic.
#pragma once

#include <cstddef>
#include <span>

#include "sim/software/cost/operations.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Prunes the tree by the known classes of primitives (reduced()), and counts a visit of each node.
template <class Count>
Tree pruned(const Tree& tree, std::span<const Known> known, Count& count) {
  const std::size_t nodes = tree.nodes.size();
  count.prune(nodes);
  count(Operation::load, 3 * nodes);
  count(Operation::compare, 2 * nodes);
  count(Operation::branch_taken, 2 * nodes);
  count(Operation::store_long, nodes);
  return reduced(tree, known);
}

}  // namespace csgsim::software
