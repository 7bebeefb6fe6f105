// States of primitives and costs of visiting nodes.
// Used by the recursive traversals.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/levels.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// A 16-bit word per primitive: whether it contains the point.
template <class Count>
class States {
 public:
  explicit States(const Tree& tree) : is_in_(tree.leaf_of.size()) {}

  void flip(std::uint32_t primitive, Count& count) {
    count(Operation::add);
    count(Operation::load);
    count(Operation::logic);
    count(Operation::store);
    count(Operation::come_back);
    is_in_[primitive] ^= 1U;
  }

  /// State of a leaf's primitive.
  std::uint8_t at(const Node& leaf, Count& count) const {
    count(Operation::load, 2);
    count(Operation::add);
    return is_in_[leaf.primitive];
  }

  [[nodiscard]] std::uint64_t words() const { return is_in_.size() / 2; }

 private:
  std::vector<std::uint8_t> is_in_;
};

/// Size in 32-bit words of a tree without parent pointers: kind and primitive, left, right.
constexpr std::uint64_t words_of(const Tree& tree) { return 3 * std::uint64_t{tree.nodes.size()}; }

/// Counts the visit of a node before its operands: its kind is read and compared with a leaf's.
template <class Count>
void count_node(const Node& node, Count& count) {
  count.visit();
  count(Operation::load);
  count(Operation::compare);
  count(node.is_leaf ? Operation::branch_taken : Operation::branch);
}

/// Counts the call for the left operand, with the node saved on the stack.
template <class Count>
void count_left(Count& count) {
  count(Operation::store_long);
  count(Operation::load_long);
  count(Operation::call);
  count(Operation::load_long);
}

/// Counts the call for the right operand; the node is already on the stack, or no longer needed.
template <class Count>
void count_right(Count& count) {
  count(Operation::load_long);
  count(Operation::call);
}

/// Combines the results of two operands.
template <class Count>
std::uint8_t combined(model::Operator op, std::uint8_t left, std::uint8_t right, Count& count) {
  count(Operation::load);
  count(Operation::compare);
  count(Operation::branch_taken);
  count(Operation::logic);
  switch (op) {
    case model::Operator::unite: return left | right;
    case model::Operator::intersect: return left & right;
    case model::Operator::subtract: break;
  }
  count(Operation::logic);
  return left & static_cast<std::uint8_t>(right ^ 1U);
}

}  // namespace csgsim::software
