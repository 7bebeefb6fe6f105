#include "host/emit/evaluation.h"

#include <string>

#include "host/emit/drawing.h"
#include "host/emit/early_out.h"
#include "host/emit/strategy.h"
#include "hw/base/error.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

void check_products(const model::Tree& tree, const Plan& plan, const Options& options) {
  const StrategyRow& strategy = row_of(options.strategy);
  if (strategy.products == nullptr) return;
  for (const SegmentPlan& segment : plan.segments) {
    std::uint64_t total = 0;
    for (const PlannedSurface& one : segment.surfaces) {
      // A surface with a single product needs no multiplication.
      const std::uint64_t products = one.active.operands.empty() ? 1 : strategy.products(one.active, options);
      if (products <= 1) continue;
      if (!__builtin_add_overflow(total, products, &total) && total <= max_products) continue;
      throw InputError(model::location_text(tree, one.primitive()) +
                       ": the tree of this primitive expands to more than " + std::to_string(max_products) +
                       " products; take --strategy stack, list or auto" +
                       (strategy.has_stack_bits ? ", or more --stack-bits" : ""));
    }
  }
}

}  // namespace

bool emit_classified(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                     const Classification& classification) {
  const std::size_t before = out.size();
  if (!classification.surface.active.operands.empty())
    out.counts.classified += classification.classify(context, out, classification.surface);
  const bool is_classified = out.size() > before;
  const isa::Origin merging{isa::Purpose::merge, planned.primitive(), isa::no_node};
  out.origin = merging;
  if (is_classified) out.plain(isa::Opcode::enable_load, context.layout.mask);
  const std::size_t merge = out.size();
  emit_merge(context, out, planned, surface);
  emit_early_out(context, out, merge, merging);
  return is_classified;
}

void emit_depth_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned, std::size_t begin) {
  emit_early_out(context, out, begin, {isa::Purpose::classify, planned.primitive(), isa::no_node});
}

void emit_base_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned,
                         const Surface& surface) {
  if (context.base.width == 0) return;
  emit_early_out(context, out, surface.begin, {isa::Purpose::render, planned.primitive(), isa::no_node});
}

void emit_visible(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                  const Classification& classification) {
  ++out.counts.depth_tests;
  emit_admission(context, out, planned);
  emit_depth_test(context, out, planned);
  const std::size_t after_test = out.size();
  if (emit_classified(context, out, planned, surface, classification))
    emit_depth_early_out(context, out, planned, after_test);
  emit_base_early_out(context, out, planned, surface);
}

ClassificationBits classification_bits(const Drawing& drawing, const Options& options) {
  const StrategyRow& strategy = row_of(options.strategy);
  check_products(*drawing.tree, drawing.plan, options);
  ClassificationBits most;
  for (const SegmentPlan& segment : drawing.plan.segments) {
    ClassificationBits bits;
    for (const PlannedSurface& one : segment.surfaces) bits = max_bits(bits, strategy.bits(one.active, options));
    if (strategy.stored_bits != nullptr) bits.stored = strategy.stored_bits(segment, drawing.view);
    most = max_bits(most, bits);
  }
  return most;
}

void emit_primitive(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const StrategyRow& strategy = row_of(context.options.strategy);
  if (strategy.draw != nullptr && strategy.draw(context, out, planned, sides)) return;
  const Surface surface = strategy.surface(context, out, planned, sides);
  if (!surface.nothing) emit_visible(context, out, planned, surface, {strategy.classify, planned});
}

}  // namespace csgsim::emit
