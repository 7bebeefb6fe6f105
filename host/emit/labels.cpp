#include <span>

#include "host/csg/ordered_list.h"
#include "host/emit/comparison.h"
#include "host/emit/strategy.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

using isa::Opcode;

/// Emits one list. The label is as wide as this list requires.
class ListEmitter {
 public:
  ListEmitter(const Context& context, Broadcast& out, const PlannedSurface& planned, unsigned label_bits)
      : context_(context),
        out_(out),
        planned_(planned),
        label_{context.layout.label.base, static_cast<std::uint16_t>(label_bits)} {}

  [[nodiscard]] std::uint64_t classified() const { return classified_; }

  void emit(std::span<const csg::ListLeaf> leaves) {
    // E is the mask. All its pixels start with label 0, that of the first leaf.
    write_label(0);
    for (const csg::ListLeaf& leaf : leaves) {
      emit_stack(out_, Opcode::enable_load, context_.layout.mask);
      if (&leaf != &leaves.front()) keep_label(leaf.name);
      emit(leaf);
    }
  }

 private:
  /// Emits a leaf, with E 1 at the pixels that wait for it.
  void emit(const csg::ListLeaf& leaf) {
    classified_ += emit_comparison(context_, out_, planned_.active.nodes[leaf.node], planned_);
    if (!stays(leaf, leaf.if_in)) {
      apply(leaf.if_in);
      if (stays(leaf, leaf.if_out)) return;
      // The pixels that still wait for this leaf are outside it.
      emit_stack(out_, Opcode::enable_load, context_.layout.mask);
      keep_label(leaf.name);
    } else {
      // E is a subset of the mask, so this gives the mask without E.
      emit_stack(out_, Opcode::enable_xor, context_.layout.mask);
      keep_label(leaf.name);
    }
    apply(leaf.if_out);
  }

  static bool stays(const csg::ListLeaf& leaf, const csg::Target& target) {
    return target.to != csg::Destination::hidden && target.label == leaf.name;
  }

  /// E := E and "the pixel's label equals `label`".
  void keep_label(std::uint32_t label) {
    for (unsigned bit = 0; bit < label_.width; ++bit) {
      const isa::Field field{static_cast<std::uint16_t>(label_.base + bit), 1};
      emit_stack(out_, (label >> bit & 1U) != 0 ? Opcode::enable_and : Opcode::enable_and_not, field);
    }
  }

  void write_label(std::uint32_t label) {
    if (label_.width > 0) emit_stack(out_, Opcode::set_constant, label_, label);
  }

  /// Applies the target where E is 1.
  void apply(const csg::Target& target) {
    if (target.to == csg::Destination::hidden) {
      emit_stack(out_, Opcode::set_constant, context_.layout.mask, 0);
    } else {
      write_label(target.label);
    }
  }

  const Context& context_;
  Broadcast& out_;
  const PlannedSurface& planned_;
  isa::Field label_;
  std::uint64_t classified_ = 0;
};

/// The width of the label that a pixel holds.
ClassificationBits list_bits(const csg::ActiveTree& active, const Options& /*options*/) {
  return {.label = csg::make_ordered_list(active).label_bits};
}

std::uint64_t emit_list(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  const csg::OrderedList list = csg::make_ordered_list(planned.active);
  ListEmitter emitter(context, out, planned, list.label_bits);
  emitter.emit(list.leaves);
  return emitter.classified();
}

}  // namespace

/// Ordered Boolean list (csg::OrderedList): the leaves in order, each for the pixels whose label names it.
extern const StrategyRow list_strategy{.bits = list_bits, .classify = emit_list};

}  // namespace csgsim::emit
