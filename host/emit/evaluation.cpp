#include "host/emit/evaluation.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/csg/products.h"
#include "host/csg/separation.h"
#include "host/emit/early_out.h"
#include "host/emit/labels.h"
#include "host/emit/levels.h"
#include "host/emit/parallel.h"
#include "host/emit/surface.h"
#include "hw/base/error.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

/// Levels that `Strategy::bits` works out by a stack: what m bits leave beside those for front, back, product and sum,
/// as figure 6.3 of the thesis shows it (the text of 6.4 says m - 3). Not for m = 3, which has no sum.
unsigned stack_levels(const Options& options) { return options.stack_bits - fewest_stack_bits - 1; }

bool renders_each_product(const Options& options) {
  return options.strategy == Strategy::products ||
         (options.strategy == Strategy::bits && options.stack_bits == fewest_stack_bits);
}

bool multiplies_out(Strategy strategy) { return strategy == Strategy::bits || strategy == Strategy::products; }

/// Products that a strategy would go through for one primitive.
std::uint64_t products_of(const PlannedSurface& planned, const Options& options) {
  if (planned.active.operands.empty() || !multiplies_out(options.strategy)) return 1;
  if (options.strategy == Strategy::bits && options.stack_bits > fewest_stack_bits) {
    return products_below_levels(planned.active, stack_levels(options));
  }
  const csg::RootedTree rooted = csg::with_root(planned.active);
  return csg::count_products(rooted.nodes)[rooted.root];
}

void check_products(const model::Tree& tree, const Plan& plan, const Options& options) {
  for (const SegmentPlan& segment : plan.segments) {
    std::uint64_t total = 0;
    for (const PlannedSurface& one : segment.surfaces) {
      // A surface that is a single product multiplies nothing.
      const std::uint64_t products = products_of(one, options);
      if (products <= 1) continue;
      if (!__builtin_add_overflow(total, products, &total) && total <= most_products) continue;
      throw InputError(model::place_of(tree, one.primitive()) +
                       ": with this primitive the tree multiplies out to more than " + std::to_string(most_products) +
                       " products; take --strategy stack, list or auto" +
                       (options.strategy == Strategy::bits ? ", or more --stack-bits" : ""));
    }
  }
}

/// Draws the surface in Z1 where it is nearer than Z2 and what is left of the mask by `classify`, which returns the
/// number of primitives compared. The depth test comes first: where it leaves nothing, nothing has to be classified.
template <class Classify>
void emit_visible(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                  const Classify& classify) {
  out.counts.rendered += planned.set.size();
  ++out.counts.depth_tests;
  emit_depth_test(context, out, planned);
  const std::size_t classification = out.size();
  out.counts.classified += classify();
  const bool is_classified = out.size() > classification;
  const isa::Origin merging{isa::Purpose::merge, planned.primitive(), isa::no_node};
  out.origin = merging;
  if (is_classified) out.plain(isa::Opcode::enable_load, context.layout.mask);
  const std::size_t merge = out.size();
  emit_merge(context, out, planned, surface);
  emit_early_out(context, out, merge, merging);
  if (is_classified)
    emit_early_out(context, out, classification, {isa::Purpose::classify, planned.primitive(), isa::no_node});
  // Where a drawing is made at some pixels only, a surface may have none of them in its rectangle.
  if (context.base.width > 0)
    emit_early_out(context, out, surface.begin, {isa::Purpose::render, planned.primitive(), isa::no_node});
}

/// Renders, classifies and merges one product.
void emit_product(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides,
                  const std::vector<csg::ActiveNode>& nodes, std::vector<std::uint32_t> leaves) {
  PlannedSurface product{planned.set, planned.block, {}, planned.number};
  product.active.nodes = nodes;
  product.active.operands = std::move(leaves);
  const Surface surface = emit_surface(context, out, planned, sides);
  if (surface.nothing) return;
  emit_visible(context, out, planned, surface, [&] { return emit_by_levels(context, out, product, all_levels); });
}

/// A product is empty if two of its solids are disjoint (thesis 6.3.2).
bool is_empty(const Context& context, const std::vector<csg::ActiveNode>& nodes,
              const std::vector<std::uint32_t>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const csg::ActiveNode& a = nodes[leaves[i]];
      const csg::ActiveNode& b = nodes[leaves[j]];
      if (!a.complemented && !b.complemented &&
          csg::disjoint(context.view, a.primitive, b.primitive, context.options.pruning)) {
        return true;
      }
    }
  }
  return false;
}

/// The products of one traversal after another: those of thesis 6.3 without the empty ones, or those of 6.4 with three
/// bits.
void emit_products(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const csg::RootedTree rooted = csg::with_root(planned.active);
  const bool leaves_out_empty = context.options.strategy == Strategy::products;
  csg::ProductTraversal traversal(rooted.nodes, rooted.root);
  do {
    if (leaves_out_empty && is_empty(context, rooted.nodes, traversal.leaves())) continue;
    emit_product(context, out, planned, sides, rooted.nodes, traversal.leaves());
  } while (traversal.next());
}

}  // namespace

ClassificationBits classification_bits(const model::Tree& tree, const Plan& plan, const Options& options) {
  check_products(tree, plan, options);
  ClassificationBits most;
  for (const SegmentPlan& segment : plan.segments) {
    for (const PlannedSurface& one : segment.surfaces) {
      ClassificationBits bits;
      switch (options.strategy) {
        case Strategy::stack: bits = bits_for_levels(one.active, all_levels); break;
        case Strategy::list: bits.label = label_bits(one.active); break;
        case Strategy::bits:
          if (!renders_each_product(options)) bits = bits_for_levels(one.active, stack_levels(options));
          break;
        case Strategy::products: break;
        case Strategy::parallel: bits.stack = string_bits(one.active); break;
        case Strategy::automatic: throw std::logic_error("no strategy was chosen");
      }
      most = {std::max(most.stack, bits.stack), std::max(most.product, bits.product), std::max(most.label, bits.label)};
    }
  }
  return most;
}

void emit_primitive(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const Options& options = context.options;
  if (renders_each_product(options) && !planned.active.operands.empty()) {
    return emit_products(context, out, planned, sides);
  }
  const Surface surface = emit_surface(context, out, planned, sides);
  if (surface.nothing) return;
  emit_visible(context, out, planned, surface, [&]() -> std::uint64_t {
    if (planned.active.operands.empty()) return 0;
    switch (options.strategy) {
      case Strategy::stack: return emit_by_levels(context, out, planned, all_levels);
      case Strategy::list: return emit_list(context, out, planned);
      case Strategy::bits: return emit_by_levels(context, out, planned, stack_levels(options));
      case Strategy::parallel: return emit_parallel(context, out, planned);
      case Strategy::products:
      case Strategy::automatic: break;
    }
    throw std::logic_error("products are drawn one by one, and no strategy is drawn before it is chosen");
  });
}

}  // namespace csgsim::emit
