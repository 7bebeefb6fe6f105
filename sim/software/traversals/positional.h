// Positional traversal.
// One of the rows of methods().
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/early_out.h"

namespace csgsim::software {

/// Visits only operands with a primitive that contains the point. Nodes have codes by position, and the primitives that
/// contain the point are sorted by the codes of their leaves (thesis 4.3.3, table 4.4).
///
/// The code of a leaf is its number from the left; the thesis instead halves a range of 2^n codes down the tree. The
/// order is the same, and there is no limit on depth. A node stores the first code of its right operand (value 1) and
/// the first code after it (value 2), so that a code equal to value 2 is outside the node.
template <class Count>
class Positional {
 public:
  /// Visits are recursive calls.
  static constexpr std::uint32_t max_levels = max_calls;

  /// Keeps a reference to the tree, which must not be constant.
  explicit Positional(const Tree& tree) : tree_(tree), middle_(tree.nodes.size()), end_(tree.nodes.size()) {
    code_of_.assign(tree.leaf_of.size(), model::no_index);
    // Parents follow their children, so ranges are computed from the end.
    std::vector<std::uint32_t> leaves(tree.nodes.size(), 1);
    for (std::size_t i = 0; i < tree.nodes.size(); ++i) {
      const Node& node = tree.nodes[i];
      if (!node.is_leaf) leaves[i] = leaves[node.left] + leaves[node.right];
    }
    end_[tree.root] = leaves[tree.root];
    for (std::size_t i = tree.root + std::size_t{1}; i-- > 0;) {
      const Node& node = tree.nodes[i];
      if (node.is_leaf) {
        code_of_[node.primitive] = end_[i] - 1;
        continue;
      }
      middle_[i] = end_[i] - leaves[node.right];
      end_[node.right] = end_[i];
      end_[node.left] = middle_[i];
    }
    codes_.assign(1, sentinel);
  }

  void clear(Count& count) {
    codes_.assign(1, sentinel);
    count(Operation::store);
  }

  void flip(std::uint32_t primitive, Count& count) {
    const std::uint32_t code = code_of_[primitive];
    std::size_t place = 0;
    count(Operation::load);
    count(Operation::come_back);
    while (codes_[place] < code) {
      ++place;
      count(Operation::load);
      count(Operation::compare);
      count(Operation::branch_taken);
    }
    count(Operation::compare, 2);
    count(Operation::branch, 2);
    const std::size_t behind = codes_.size() - place;
    count(Operation::load, behind);
    count(Operation::store, behind);
    count(Operation::branch_taken, behind);
    if (codes_[place] == code) {
      codes_.erase(codes_.begin() + static_cast<std::ptrdiff_t>(place));
    } else {
      codes_.insert(codes_.begin() + static_cast<std::ptrdiff_t>(place), code);
      count(Operation::store);
    }
  }

  bool evaluate(Count& count) {
    next_ = 0;
    count(Operation::load);
    count(Operation::compare);
    if (codes_.front() == sentinel) {
      count(Operation::branch_taken);
      count(Operation::come_back);
      return false;
    }
    return visit(tree_.root, count) != 0;
  }

  /// Each node additionally stores two codes.
  [[nodiscard]] std::uint64_t words() const {
    return words_of(tree_) + middle_.size() + code_of_.size() / 2 + codes_.capacity() / 2;
  }

 private:
  static constexpr std::uint32_t sentinel = 0xffffffffU;

  /// Visits a node that contains the next code.
  std::uint8_t visit(std::uint32_t at, Count& count) {
    const Node& node = tree_.nodes[at];
    count_node(node, count);
    count(Operation::come_back);
    if (node.is_leaf) {
      ++next_;
      count(Operation::load);
      count(Operation::add);
      return 1;
    }
    std::uint8_t left = 0;
    if (is_next_below(middle_[at], count)) {
      count_left(count);
      left = visit(node.left, count);
    }
    count(Operation::load);
    count(Operation::compare, 2);
    if (is_decided(node.op, left)) {
      count(Operation::branch_taken, 2);
      leave_out(end_[at], count);
      return left;
    }
    count(Operation::branch_taken);
    count(Operation::branch);
    std::uint8_t right = 0;
    if (is_next_below(end_[at], count)) {
      count_right(count);
      right = visit(node.right, count);
    }
    if (node.op != model::Operator::subtract) return right;
    count(Operation::logic);
    return right ^ 1U;
  }

  bool is_next_below(std::uint32_t code, Count& count) const {
    const bool is_below = codes_[next_] < code;
    count(Operation::load);
    count(Operation::compare);
    count(is_below ? Operation::branch : Operation::branch_taken);
    return is_below;
  }

  /// Skips the codes of an operand that is not visited.
  void leave_out(std::uint32_t end, Count& count) {
    if (codes_[next_] < end) count.early_out();
    while (is_next_below(end, count)) {
      ++next_;
      count(Operation::add);
      count(Operation::branch_taken);
    }
  }

  const Tree& tree_;
  std::vector<std::uint32_t> middle_;
  std::vector<std::uint32_t> end_;
  std::vector<std::uint32_t> code_of_;  ///< per primitive
  std::vector<std::uint32_t> codes_;    ///< codes of primitives that contain the point, sorted, and a sentinel
  std::size_t next_ = 0;
};

}  // namespace csgsim::software
