// Standard traversal.
// One of the rows of methods().
#pragma once

#include <cstdint>
#include <span>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/states.h"

namespace csgsim::software {

/// Evaluates the whole tree in postorder for each point (thesis 4.3.1, table 4.2).
template <class Count>
class Standard : public States<Count> {
 public:
  /// Visits are recursive calls.
  static constexpr std::uint32_t max_levels = max_calls;

  /// Keeps a reference to the tree, which must not be constant.
  explicit Standard(const Tree& tree) : States<Count>(tree), tree_(tree) {}

  /// Whether the solid contains the point.
  bool evaluate(Count& count) { return visit(tree_.root, count) != 0; }

  [[nodiscard]] std::uint64_t words() const { return words_of(tree_) + States<Count>::words(); }

 private:
  std::uint8_t visit(std::uint32_t at, Count& count) {
    const Node& node = tree_.nodes[at];
    count_node(node, count);
    count(Operation::come_back);
    if (node.is_leaf) return this->at(node, count);
    count_left(count);
    const std::uint8_t left = visit(node.left, count);
    count(Operation::store);
    count_right(count);
    const std::uint8_t right = visit(node.right, count);
    count(Operation::load);
    count(Operation::load_long);
    return combined(node.op, left, right, count);
  }

  const Tree& tree_;
};

}  // namespace csgsim::software
