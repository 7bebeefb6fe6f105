// Early-out traversal.
// One of the rows of methods(), also used by weave and interval arithmetic.
#pragma once

#include <cstdint>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/states.h"

namespace csgsim::software {

/// Whether the left operand decides alone: inside for a union, outside for other operators.
constexpr bool is_decided(model::Operator op, std::uint8_t left) {
  return (op == model::Operator::unite) == (left != 0);
}

/// Like the standard traversal, but skips the right operand if the left one decides (thesis 4.3.2, table 4.3).
template <class Count>
class EarlyOut : public States<Count> {
 public:
  /// Visits are recursive calls.
  static constexpr std::uint32_t max_levels = max_calls;

  /// Keeps a reference to the tree, which must not be constant.
  explicit EarlyOut(const Tree& tree) : States<Count>(tree), tree_(tree) {}

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
    count(Operation::load);
    count(Operation::compare, 2);
    if (is_decided(node.op, left)) {
      count(Operation::branch_taken, 2);
      count.early_out();
      return left;
    }
    count(Operation::branch_taken);
    count(Operation::branch);
    // The right operand decides: it is the result of a union or intersection, and its complement that of a difference.
    count_right(count);
    const std::uint8_t right = visit(node.right, count);
    if (node.op != model::Operator::subtract) return right;
    count(Operation::logic);
    return right ^ 1U;
  }

  const Tree& tree_;
};

}  // namespace csgsim::software
