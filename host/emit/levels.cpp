#include "host/emit/levels.h"

#include <algorithm>

#include "host/csg/products.h"
#include "host/emit/comparison.h"
#include "host/emit/strategy.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using csg::PositiveOperator;
using isa::Opcode;

/// Emits the evaluation of an active tree. E and all results are kept within the mask, the pixels where Z1 is a
/// surface: a bit of the stack is first stored from E at every pixel, and later set to 1 only where E is 1. Hence a
/// result is 0 outside the mask, and no further AND with the mask is needed.
class Classifier {
 public:
  Classifier(const Context& context, Broadcast& out, const PlannedSurface& planned, unsigned levels)
      : context_(context), out_(out), planned_(planned), nodes_(planned.active.nodes), levels_(levels) {}

  std::uint64_t classified() const { return classified_; }

  /// mask := mask and every operand of the active tree.
  void run() {
    const std::vector<std::uint32_t>& operands = planned_.active.operands;
    if (operands.size() > 1 && levels_ == 0) {
      run_as_products();
      return;
    }
    for (const std::uint32_t operand : operands) {
      if (nodes_[operand].is_leaf) {
        combine_leaf(operand, PositiveOperator::intersect, context_.layout.mask);
      } else {
        evaluate(operand, operands.size() > 1 ? 2 : 1);
        narrow_mask_by(context_.layout.stack[0]);
      }
    }
  }

 private:
  void stack(Opcode opcode, isa::Field field) { emit_stack(out_, opcode, field); }
  void set_bit(isa::Field bit, bool value) { emit_stack(out_, Opcode::set_constant, bit, value ? 1 : 0); }

  /// mask := mask and the result.
  void narrow_mask_by(isa::Field result) {
    stack(Opcode::enable_load, result);
    stack(Opcode::enable_store, context_.layout.mask);
  }

  void run_as_products() {
    const csg::RootedTree whole = csg::make_rooted_tree(planned_.active);
    sum_products(whole.nodes, whole.root, context_.layout.stack[0]);
    narrow_mask_by(context_.layout.stack[0]);
  }

  /// E := E and "Z1 is in the leaf's primitives".
  void compare(const csg::ActiveNode& leaf) { classified_ += emit_comparison(context_, out_, leaf, planned_); }

  /// bit := "Z1 is in the leaf's primitives".
  void start_leaf(std::uint32_t leaf, isa::Field bit) {
    const csg::ActiveNode& node = nodes_[leaf];
    stack(Opcode::enable_load, context_.layout.mask);
    compare(node);
    if (node.complemented) stack(Opcode::enable_xor, context_.layout.mask);
    stack(Opcode::enable_store, bit);
  }

  /// bit := bit op the leaf.
  void combine_leaf(std::uint32_t leaf, PositiveOperator op, isa::Field bit) {
    const csg::ActiveNode& node = nodes_[leaf];
    if (op == PositiveOperator::intersect) {
      classified_ += emit_intersection(context_, out_, node, planned_, bit);
      return;
    }
    stack(Opcode::enable_load, context_.layout.mask);
    compare(node);
    if (node.complemented) stack(Opcode::enable_xor, context_.layout.mask);
    set_bit(bit, true);
  }

  /// bit := bit op the result above it on the stack.
  void combine_result(PositiveOperator op, isa::Field bit, isa::Field above) {
    stack(Opcode::enable_load, above);
    if (op == PositiveOperator::unite) {
      set_bit(bit, true);
    } else {
      stack(Opcode::enable_and, bit);
      stack(Opcode::enable_store, bit);
    }
  }

  /// bit := the subtree as the sum of its products, which are computed one traversal after another.
  void sum_products(const std::vector<csg::ActiveNode>& nodes, std::uint32_t root, isa::Field bit) {
    csg::ProductTraversal traversal(nodes, root);
    emit_product(nodes, traversal.leaves());
    stack(Opcode::enable_store, bit);
    while (traversal.next()) {
      emit_product(nodes, traversal.leaves());
      set_bit(bit, true);
    }
  }

  /// E := the mask and every leaf. The intersection of the leaves compared until now is in E, or else in the product
  /// bit.
  void emit_product(const std::vector<csg::ActiveNode>& nodes, const std::vector<std::uint32_t>& leaves) {
    const isa::Field product = context_.layout.product;
    isa::Field left = context_.layout.mask;
    bool in_enable = false;
    for (const std::uint32_t leaf : leaves) {
      const bool complemented = nodes[leaf].complemented;
      if (complemented && in_enable) {
        stack(Opcode::enable_store, product);
        left = product;
      } else if (!in_enable) {
        stack(Opcode::enable_load, left);
      }
      compare(nodes[leaf]);
      if (complemented) stack(Opcode::enable_xor, left);
      in_enable = true;
    }
  }

  /// stack[0] := the operator node, evaluated in postorder without recursion, so that deep trees do not overflow the
  /// stack.
  void evaluate(std::uint32_t root, unsigned root_level) {
    struct Visit {
      std::uint32_t node;
      unsigned level;
      std::size_t bit;
      std::size_t next = 0;
    };
    std::vector<Visit> path{{root, root_level, 0}};
    while (!path.empty()) {
      Visit& visit = path.back();
      const csg::ActiveNode& node = nodes_[visit.node];
      const isa::Field bit = context_.layout.stack[visit.bit];
      if (visit.level > levels_) {
        sum_products(nodes_, visit.node, bit);
        path.pop_back();
        continue;
      }
      // The result of each operator operand after the first is in the next stack bit.
      if (visit.next > 1 && !nodes_[node.children[visit.next - 1]].is_leaf) {
        combine_result(node.op, bit, context_.layout.stack[visit.bit + 1]);
      }
      bool descend = false;
      while (!descend && visit.next < node.children.size()) {
        const std::uint32_t child = node.children[visit.next++];
        if (nodes_[child].is_leaf) {
          visit.next == 1 ? start_leaf(child, bit) : combine_leaf(child, node.op, bit);
        } else {
          path.push_back({child, visit.level + 1, visit.next == 1 ? visit.bit : visit.bit + 1});
          descend = true;
        }
      }
      if (!descend) path.pop_back();
    }
  }

  const Context& context_;
  Broadcast& out_;
  const PlannedSurface& planned_;
  const std::vector<csg::ActiveNode>& nodes_;
  unsigned levels_;
  std::uint64_t classified_ = 0;
};

/// The level of each node below an operand, counted from the top.
std::vector<unsigned> node_levels(const csg::ActiveTree& active) {
  std::vector<unsigned> levels(active.nodes.size(), 0);
  for (const std::uint32_t operand : active.operands) levels[operand] = active.operands.size() > 1 ? 2 : 1;
  for (std::size_t i = active.nodes.size(); i-- > 0;) {
    for (const std::uint32_t child : active.nodes[i].children) levels[child] = levels[i] + 1;
  }
  return levels;
}

}  // namespace

std::uint64_t products_below_levels(const csg::ActiveTree& active, unsigned levels) {
  const std::vector<std::uint64_t> counts = csg::count_products(active.nodes);
  std::uint64_t total = 0;
  if (levels == 0) {
    total = 1;
    for (const std::uint32_t operand : active.operands) {
      if (__builtin_mul_overflow(total, counts[operand], &total)) return csg::countless;
    }
    return total;
  }
  const std::vector<unsigned> level = node_levels(active);
  for (std::size_t i = 0; i < active.nodes.size(); ++i) {
    if (active.nodes[i].is_leaf || level[i] != levels + 1) continue;
    if (__builtin_add_overflow(total, counts[i], &total)) return csg::countless;
  }
  return total;
}

ClassificationBits bits_for_levels(const csg::ActiveTree& active, unsigned levels) {
  ClassificationBits bits;
  if (active.operands.size() > 1 && levels == 0) return {1, 1, 0};
  const std::vector<unsigned> level = node_levels(active);
  std::vector<unsigned> needed(active.nodes.size(), 0);
  for (std::size_t i = 0; i < active.nodes.size(); ++i) {
    const csg::ActiveNode& node = active.nodes[i];
    if (node.is_leaf || level[i] == 0) continue;
    needed[i] = 1;
    if (level[i] > levels) {
      if (level[i] == levels + 1) bits.product = 1;
      continue;
    }
    for (std::size_t child = 0; child < node.children.size(); ++child) {
      const unsigned below = needed[node.children[child]];
      if (below > 0) needed[i] = std::max(needed[i], child == 0 ? below : below + 1);
    }
  }
  for (const std::uint32_t operand : active.operands) bits.stack = std::max(bits.stack, needed[operand]);
  return bits;
}

std::uint64_t emit_by_levels(const Context& context, Broadcast& out, const PlannedSurface& planned, unsigned levels) {
  Classifier classifier(context, out, planned, levels);
  classifier.run();
  return classifier.classified();
}

ClassificationBits bits_for_all_levels(const csg::ActiveTree& active, const Options& /*options*/) {
  return bits_for_levels(active, all_levels);
}

std::uint64_t emit_by_all_levels(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  return emit_by_levels(context, out, planned, all_levels);
}

/// Evaluates the active tree once per primitive, with one bit for each pending result.
extern const StrategyRow stack_strategy{.bits = bits_for_all_levels, .classify = emit_by_all_levels};

}  // namespace csgsim::emit
