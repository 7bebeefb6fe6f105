#pragma once

#include <cstdint>
#include <limits>
#include <vector>

#include "host/csg/active_tree.h"

namespace csgsim::csg {

inline constexpr std::uint64_t countless = std::numeric_limits<std::uint64_t>::max();

/// An active tree's nodes under one root: its only operand, or the intersection of its operands.
struct RootedTree {
  std::vector<ActiveNode> nodes;
  std::uint32_t root = 0;
};

/// The tree must have operands.
RootedTree with_root(const ActiveTree& active);

/// Products of the sum that each node of a tree multiplies out to (thesis 6.3.1): unions add, intersections multiply.
/// `countless` where the number does not fit.
std::vector<std::uint64_t> count_products(const std::vector<ActiveNode>& nodes);

/// Products by repeated traversal (thesis 6.4): at a union one operand at a time is visited, at an intersection all.
/// They come in the order, and with the leaves, that restructuring the tree gives (6.3), the rightmost union varying
/// fastest, but no product is ever held except the one that is visited. Refers to the nodes.
class ProductTraversal {
 public:
  ProductTraversal(const std::vector<ActiveNode>& nodes, std::uint32_t root);

  /// Leaves that the present traversal visits, in the order of the visit.
  [[nodiscard]] const std::vector<std::uint32_t>& leaves() const { return leaves_; }

  /// Goes on to the next product; false if there is none.
  bool next();

 private:
  void visit();

  const std::vector<ActiveNode>& nodes_;
  std::uint32_t root_;
  std::vector<std::uint32_t> chosen_;  ///< for each union the operand that is visited
  std::vector<std::uint32_t> unions_;  ///< unions on the way, in the order of the visit
  std::vector<std::uint32_t> leaves_;
};

}  // namespace csgsim::csg
