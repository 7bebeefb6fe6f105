// Bit-sequential traversal.
// One of the rows of methods().
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "sim/software/cost/operations.h"
#include "sim/software/traversals/bit_string.h"
#include "sim/software/traversals/states.h"

namespace csgsim::software {

/// The tree in postorder as a list of steps over a bit string with a stack of bits (thesis 4.4.1, table 4.6). There are
/// no calls and no branches on the states of points, so that all pixels can execute the steps in lockstep.
template <class Count>
class BitSequential {
 public:
  static constexpr std::uint32_t max_levels = any_levels;

  explicit BitSequential(const Tree& tree)
      : states_(tree.leaf_of.size(), Kept::in_memory), stack_(tree.depth() + std::size_t{1}, Kept::in_register) {
    // Operands precede their operator, left before right, independent of the order of nodes.
    struct Entry {
      std::uint32_t node;
      bool is_open;
    };
    std::vector<Entry> open{{tree.root, false}};
    while (!open.empty()) {
      const Entry entry = open.back();
      open.pop_back();
      const Node& node = tree.nodes[entry.node];
      if (node.is_leaf) {
        steps_.push_back({node.primitive, model::Operator::unite});
      } else if (entry.is_open) {
        steps_.push_back({model::no_index, node.op});
      } else {
        open.push_back({entry.node, true});
        open.push_back({node.right, false});
        open.push_back({node.left, false});
      }
    }
  }

  void flip(std::uint32_t primitive, Count& count) {
    count(Operation::come_back);
    states_.flip(primitive, count);
  }

  bool evaluate(Count& count) {
    std::size_t top = 0;
    count(Operation::come_back);
    for (const Step& step : steps_) {
      count.visit();
      count(Operation::load);
      count(Operation::branch_taken);
      if (step.primitive != model::no_index) {
        stack_.set(top++, states_.get(step.primitive, count), count);
        continue;
      }
      --top;
      const std::uint32_t right = stack_.get(top, count);
      const std::uint32_t left = stack_.get(top - 1, count);
      count(Operation::logic);
      switch (step.op) {
        case model::Operator::unite: stack_.set(top - 1, left | right, count); break;
        case model::Operator::intersect: stack_.set(top - 1, left & right, count); break;
        case model::Operator::subtract:
          count(Operation::logic);
          stack_.set(top - 1, left & (right ^ 1U), count);
          break;
      }
    }
    return stack_.get(0, count) != 0;
  }

  [[nodiscard]] std::uint64_t words() const { return steps_.size() + states_.word_count() + stack_.word_count(); }

 private:
  /// A leaf, or an operator if it has no primitive.
  struct Step {
    std::uint32_t primitive;
    model::Operator op;
  };

  std::vector<Step> steps_;
  BitString<Count> states_;
  BitString<Count> stack_;
};

}  // namespace csgsim::software
