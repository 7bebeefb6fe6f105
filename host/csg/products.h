// Products of active trees, multiplied out or by repeated traversal.
// Used by host/emit.
#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "host/csg/active_tree.h"

namespace csgsim::csg {

/// A count that does not fit 64 bits.
inline constexpr std::uint64_t countless = std::numeric_limits<std::uint64_t>::max();

/// An active tree's nodes under one root: its only operand, or the intersection of its operands.
struct RootedTree {
  std::vector<ActiveNode> nodes;
  std::uint32_t root = 0;
};

/// The nodes of an active tree, which must have operands, under one root.
RootedTree make_rooted_tree(const ActiveTree& active);

/// Number of products of the sum that each node of a tree expands to (thesis 6.3.1): unions add, intersections
/// multiply. `countless` on overflow.
std::vector<std::uint64_t> count_products(const std::vector<ActiveNode>& nodes);

/// Products by repeated traversal (thesis 6.4): a union visits one operand at a time, an intersection all of them. The
/// products have the order and the leaves that restructuring the tree gives (6.3), with the rightmost union varying
/// fastest, but only the current product is stored. Keeps a reference to the nodes.
class ProductTraversal {
 public:
  ProductTraversal(const std::vector<ActiveNode>& nodes, std::uint32_t root);

  /// Leaves of the current traversal, in the order of visits.
  [[nodiscard]] const std::vector<std::uint32_t>& leaves() const { return leaves_; }

  /// Advances to the next product; returns false if there is none.
  bool next();

 private:
  void visit();

  const std::vector<ActiveNode>& nodes_;
  std::uint32_t root_;
  std::vector<std::uint32_t> chosen_;  ///< by node: the operand that a union visits
  std::vector<std::uint32_t> unions_;  ///< unions of the current traversal, in the order of visits
  std::vector<std::uint32_t> leaves_;
};

}  // namespace csgsim::csg
