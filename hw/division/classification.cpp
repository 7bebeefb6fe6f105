#include "hw/division/classification.h"

#include <fmt/format.h>

#include "hw/base/error.h"

namespace csgsim::division {

namespace {

using isa::Opcode;
using isa::Purpose;

/// A result bit must be 0 outside the mask: it is first stored from E at every pixel, and later set to 1 only where E
/// is 1.
class Classifier {
 public:
  Classifier(Writer& out, Datapath& path, const ActiveTree& active, const Surface& surface)
      : out_(out), path_(path), fields_(path.header().fields), active_(active), surface_(surface) {}

  void run() {
    const isa::Field mask = fields_.mask;
    for (const std::uint32_t operand : active_.operands) {
      if (active_.terms[operand].is_leaf) {
        intersect(active_.terms[operand], mask);
        continue;
      }
      evaluate(operand);
      step(Opcode::enable_load, result(0));
      step(Opcode::enable_store, mask);
    }
  }

 private:
  /// An operator whose evaluation into a result bit is in progress.
  struct PendingOperator {
    std::uint32_t term;
    std::uint32_t bit;
    std::size_t next = 0;
  };

  [[nodiscard]] isa::Field result(std::uint32_t bit) const {
    if (bit >= fields_.stack_bits) {
      throw InputError(fmt::format(
          "a square's tree needs {} bits for intermediate results, but pixel memory has {}; increase array.memory_bits",
          bit + 1, fields_.stack_bits));
    }
    return {static_cast<std::uint16_t>(fields_.stack_base + bit), 1};
  }

  void step(Opcode opcode, isa::Field field, std::uint64_t constant = 0) {
    out_.origin = {Purpose::stack, surface_.first, isa::no_node};
    out_.plain(opcode, field, {}, constant);
  }

  /// E := E and "Z1 is inside the primitive".
  void compare(const Comparison& with) {
    const Box box{with.pixels, surface_.box.z_low, surface_.box.z_high};
    out_.origin = {Purpose::classify, surface_.first, with.primitive};
    out_.clip(with.pixels, surface_.box.pixels);
    out_.edges(with.tested, with.pixels);
    for (const Side side : {Side::front, Side::back}) {
      const Opcode opcode = side == Side::front ? Opcode::linear_le : Opcode::linear_gt;
      for (const TestedHalfspace& one : find_extremes(path_, with.tested, side, box).facets) {
        out_.depth(opcode, fields_.candidate, one.plane, with.pixels);
      }
    }
  }

  void compare(const Term& leaf) {
    for (const Comparison& with : leaf.comparisons) compare(with);
  }

  /// E := the leaf, within the mask.
  void load(const Term& leaf) {
    step(Opcode::enable_load, fields_.mask);
    compare(leaf);
    if (leaf.complemented) step(Opcode::enable_xor, fields_.mask);
  }

  /// bit := bit and the leaf.
  void intersect(const Term& leaf, isa::Field bit) {
    step(Opcode::enable_load, bit);
    compare(leaf);
    leaf.complemented ? step(Opcode::set_constant, bit, 0) : step(Opcode::enable_store, bit);
  }

  void take_leaf(const Term& leaf, Operator op, isa::Field bit, bool is_first) {
    if (is_first) {
      load(leaf);
      step(Opcode::enable_store, bit);
    } else if (op == Operator::intersect) {
      intersect(leaf, bit);
    } else {
      load(leaf);
      step(Opcode::set_constant, bit, 1);
    }
  }

  /// bit := bit op the result stored in the next bit.
  void take_result(Operator op, isa::Field bit, isa::Field above) {
    step(Opcode::enable_load, above);
    if (op == Operator::unite) {
      step(Opcode::set_constant, bit, 1);
    } else {
      step(Opcode::enable_and, bit);
      step(Opcode::enable_store, bit);
    }
  }

  /// Evaluates the operator into result(0). Its operands that are operators, except the first, are evaluated into the
  /// next bit.
  void evaluate(std::uint32_t root) {
    std::vector<PendingOperator> pending{{root, 0}};
    while (!pending.empty()) {
      PendingOperator& top = pending.back();
      const Term& term = active_.terms[top.term];
      const isa::Field bit = result(top.bit);
      if (top.next > 1 && !active_.terms[term.operands[top.next - 1]].is_leaf)
        take_result(term.op, bit, result(top.bit + 1));
      while (top.next < term.operands.size() && active_.terms[term.operands[top.next]].is_leaf) {
        take_leaf(active_.terms[term.operands[top.next]], term.op, bit, top.next == 0);
        ++top.next;
      }
      if (top.next == term.operands.size()) {
        pending.pop_back();
      } else {
        const std::uint32_t below = top.next == 0 ? top.bit : top.bit + 1;
        pending.push_back({term.operands[top.next++], below});
      }
    }
  }

  Writer& out_;
  Datapath& path_;
  const Fields& fields_;
  const ActiveTree& active_;
  const Surface& surface_;
};

}  // namespace

void write_classification(Writer& out, Datapath& path, const ActiveTree& active, const Surface& surface) {
  Classifier(out, path, active, surface).run();
}

}  // namespace csgsim::division
