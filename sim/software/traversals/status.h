// Status tree traversal.
// One of the rows of methods(), also used to find owners.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/states.h"

namespace csgsim::software {

/// Each node stores whether it contains the point. A change of a primitive is propagated from its leaf upwards until a
/// node is unchanged (Sato et al. 1985; thesis 4.3.4, table 4.5).
template <class Count>
class StatusTree {
 public:
  static constexpr std::uint32_t max_levels = any_levels;

  /// Keeps a reference to the tree, which must not be constant.
  explicit StatusTree(const Tree& tree) : tree_(tree), status_(tree.nodes.size()) {}

  void flip(std::uint32_t primitive, Count& count) {
    std::uint32_t at = tree_.leaf_of[primitive];
    count.visit();
    count(Operation::come_back);
    count(Operation::add);
    count(Operation::load_long);
    count(Operation::load);
    count(Operation::logic);
    count(Operation::store);
    status_[at] ^= 1U;
    while (at != tree_.root) {
      at = tree_.nodes[at].parent;
      const Node& node = tree_.nodes[at];
      count.visit();
      count(Operation::load_long, 3);
      count(Operation::load, 2);
      const std::uint8_t now = combined(node.op, status_[node.left], status_[node.right], count);
      count(Operation::load);
      count(Operation::compare, 2);
      if (now == status_[at]) {
        count(Operation::branch_taken);
        count.early_out();
        return;
      }
      count(Operation::branch);
      count(Operation::branch_taken);
      count(Operation::store);
      status_[at] = now;
    }
    count(Operation::branch_taken);
  }

  bool evaluate(Count& count) const {
    count(Operation::load);
    count(Operation::come_back);
    return status_[tree_.root] != 0;
  }

  /// Whether a node contains the point.
  [[nodiscard]] bool holds(std::uint32_t node) const { return status_[node] != 0; }

  /// Each node additionally stores a parent pointer and its status.
  [[nodiscard]] std::uint64_t words() const { return words_of(tree_) + 2 * tree_.nodes.size() + tree_.leaf_of.size(); }

 private:
  const Tree& tree_;
  std::vector<std::uint8_t> status_;
};

}  // namespace csgsim::software
