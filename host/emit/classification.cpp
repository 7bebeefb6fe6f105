#include "host/emit/context.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;

/// Emits the evaluation of an active tree with one bit a pending result (thesis 6.4 with a full stack). E is kept
/// inside the mask, where Z1 is a surface; what a result is elsewhere does not matter.
class Classifier {
 public:
  Classifier(const Context& context, Broadcast& out, const csg::ActiveTree& active, const csg::Block& block)
      : context_(context), out_(out), active_(active), block_(block) {}

  std::uint64_t classified() const { return classified_; }

  /// mask := mask and every operand of the active tree.
  void run() {
    const isa::Field mask = context_.layout.mask;
    for (const std::uint32_t operand : active_.operands) {
      if (active_.nodes[operand].is_leaf) {
        combine_leaf(operand, csg::PositiveOperator::intersect, mask);
        continue;
      }
      evaluate(operand);
      stack(Opcode::enable_load, context_.layout.stack[0]);
      stack(Opcode::enable_and, mask);
      stack(Opcode::enable_store, mask);
    }
  }

 private:
  void stack(Opcode opcode, isa::Field field) {
    out_.origin = {isa::Purpose::stack, out_.origin.primitive, isa::no_node};
    out_.plain(opcode, field);
  }

  void set_bit(isa::Field bit, bool value) {
    out_.origin = {isa::Purpose::stack, out_.origin.primitive, isa::no_node};
    out_.plain(Opcode::set_constant, bit, {}, value ? 1 : 0);
  }

  /// E := E and "Z1 is in the primitive". E has to be inside the mask.
  void compare(std::uint32_t primitive) {
    ++classified_;
    out_.origin = {isa::Purpose::classify, out_.origin.primitive, primitive};
    const view::PixelRect shared = common(block_.pixels, context_.view.extents[primitive].pixels);
    out_.clip(shared, block_.pixels);
    const csg::Block part{shared, block_.z_low, block_.z_high};
    emit_edges(context_, out_, primitive, part);
    for (const facet::Halfspace& halfspace : context_.scene.solids[primitive].halfspaces) {
      const view::ScreenPlane& plane = context_.view.planes[halfspace.plane];
      if (plane.kind == view::PlaneKind::edge || csg::locate(context_.view, halfspace, part) == csg::Known::in)
        continue;
      require_representable(context_, primitive, halfspace);
      const bool front = view::side_of(plane, halfspace) == view::Side::front;
      out_.surface(front ? Opcode::linear_le : Opcode::linear_gt, context_.layout.candidate, plane.linear, shared);
    }
  }

  /// bit := the leaf.
  void start_leaf(std::uint32_t leaf, isa::Field bit) {
    const csg::ActiveNode& node = active_.nodes[leaf];
    stack(Opcode::enable_load, context_.layout.mask);
    compare(node.primitive);
    if (node.complemented) stack(Opcode::enable_xor, context_.layout.mask);
    stack(Opcode::enable_store, bit);
  }

  /// bit := bit op the leaf.
  void combine_leaf(std::uint32_t leaf, csg::PositiveOperator op, isa::Field bit) {
    const csg::ActiveNode& node = active_.nodes[leaf];
    const bool intersect = op == csg::PositiveOperator::intersect;
    stack(Opcode::enable_load, intersect ? bit : context_.layout.mask);
    compare(node.primitive);
    if (intersect && !node.complemented) {
      stack(Opcode::enable_store, bit);
    } else if (intersect) {
      set_bit(bit, false);
    } else {
      if (node.complemented) stack(Opcode::enable_xor, context_.layout.mask);
      set_bit(bit, true);
    }
  }

  /// bit := bit op the result above it on the stack.
  void combine_result(csg::PositiveOperator op, isa::Field bit, isa::Field above) {
    stack(Opcode::enable_load, above);
    if (op == csg::PositiveOperator::unite) {
      set_bit(bit, true);
    } else {
      stack(Opcode::enable_and, bit);
      stack(Opcode::enable_store, bit);
    }
  }

  /// stack[0] := the operator node, worked out in postorder without recursion, so that no tree is too deep.
  void evaluate(std::uint32_t root) {
    struct Frame {
      std::uint32_t node;
      std::size_t level;
      std::size_t next = 0;
    };
    std::vector<Frame> path{{root, 0}};
    while (!path.empty()) {
      Frame& frame = path.back();
      const csg::ActiveNode& node = active_.nodes[frame.node];
      const isa::Field bit = context_.layout.stack[frame.level];
      // Every operand after the first that is an operator was worked out one level up.
      if (frame.next > 1 && !active_.nodes[node.children[frame.next - 1]].is_leaf) {
        combine_result(node.op, bit, context_.layout.stack[frame.level + 1]);
      }
      bool descend = false;
      while (!descend && frame.next < node.children.size()) {
        const std::uint32_t child = node.children[frame.next++];
        if (active_.nodes[child].is_leaf) {
          frame.next == 1 ? start_leaf(child, bit) : combine_leaf(child, node.op, bit);
        } else {
          path.push_back({child, frame.next == 1 ? frame.level : frame.level + 1});
          descend = true;
        }
      }
      if (!descend) path.pop_back();
    }
  }

  const Context& context_;
  Broadcast& out_;
  const csg::ActiveTree& active_;
  const csg::Block& block_;
  std::uint64_t classified_ = 0;
};

}  // namespace

std::uint64_t emit_classification(const Context& context, Broadcast& out, const csg::ActiveTree& active,
                                  const csg::Block& block) {
  Classifier classifier(context, out, active, block);
  classifier.run();
  out.origin.node = isa::no_node;
  return classifier.classified();
}

}  // namespace csgsim::emit
