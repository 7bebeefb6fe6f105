#include "host/emit/evaluation.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "host/csg/products.h"
#include "host/csg/separation.h"
#include "host/emit/drawing.h"
#include "host/emit/early_out.h"
#include "host/emit/labels.h"
#include "host/emit/levels.h"
#include "host/emit/parallel.h"
#include "host/emit/polygons.h"
#include "host/emit/stored.h"
#include "host/emit/surface.h"
#include "hw/base/error.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

/// Levels that `Strategy::bits` works out by a stack: what m bits leave beside those for front, back, product and sum,
/// as figure 6.3 of the thesis shows it (the text of 6.4 says m - 3). Not for m = 3, which has no sum.
unsigned stack_levels(const Options& options) { return options.stack_bits - fewest_stack_bits - 1; }

/// Whether a primitive is merged product by product: there is no bit to sum them in.
bool merges_each_product(const Options& options) {
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

/// Merges the surface in Z1 where `classify`, which returns the number of primitives compared, leaves the mask. Whether
/// that took any instruction.
template <class Classify>
bool emit_classified(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                     const Classify& classify) {
  const std::size_t classification = out.size();
  out.counts.classified += classify();
  const bool is_classified = out.size() > classification;
  const isa::Origin merging{isa::Purpose::merge, planned.primitive(), isa::no_node};
  out.origin = merging;
  if (is_classified) out.plain(isa::Opcode::enable_load, context.layout.mask);
  const std::size_t merge = out.size();
  emit_merge(context, out, planned, surface);
  emit_early_out(context, out, merge, merging);
  return is_classified;
}

/// What was appended from `begin` on, right after a depth test, is skipped where that leaves nothing.
void emit_depth_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned, std::size_t begin) {
  emit_early_out(context, out, begin, {isa::Purpose::classify, planned.primitive(), isa::no_node});
}

/// Where a drawing is made at some pixels only, a surface may have none of them in its rectangle.
void emit_base_early_out(const Context& context, Broadcast& out, const PlannedSurface& planned,
                         const Surface& surface) {
  if (context.base.width == 0) return;
  emit_early_out(context, out, surface.begin, {isa::Purpose::render, planned.primitive(), isa::no_node});
}

/// Draws the surface in Z1 where it is nearer than Z2 and what is left of the mask by `classify`. The depth test comes
/// first: where it leaves nothing, nothing has to be classified.
template <class Classify>
void emit_visible(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface,
                  const Classify& classify) {
  ++out.counts.depth_tests;
  emit_admission(context, out, planned);
  emit_depth_test(context, out, planned);
  const std::size_t classification = out.size();
  if (emit_classified(context, out, planned, surface, classify))
    emit_depth_early_out(context, out, planned, classification);
  emit_base_early_out(context, out, planned, surface);
}

/// The surface with the leaves of one product for its active tree.
PlannedSurface with_product(const PlannedSurface& planned, const std::vector<csg::ActiveNode>& nodes,
                            std::vector<std::uint32_t> leaves) {
  PlannedSurface product{planned.set, planned.block, {}, planned.number};
  product.active.nodes = nodes;
  product.active.operands = std::move(leaves);
  return product;
}

/// A product is empty if two of its solids are disjoint (thesis 6.3.2).
bool is_empty(const Context& context, const std::vector<csg::ActiveNode>& nodes,
              const std::vector<std::uint32_t>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const csg::ActiveNode& a = nodes[leaves[i]];
      const csg::ActiveNode& b = nodes[leaves[j]];
      if (!a.complemented && !b.complemented &&
          csg::disjoint(context.view, a.primitive, b.primitive, context.options.pruning, context.counted)) {
        return true;
      }
    }
  }
  return false;
}

/// The products of thesis 6.3 but the empty ones: each is rendered, classified and merged.
void emit_rendered_products(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const csg::RootedTree rooted = csg::with_root(planned.active);
  csg::ProductTraversal traversal(rooted.nodes, rooted.root);
  do {
    if (is_empty(context, rooted.nodes, traversal.leaves())) continue;
    const Surface surface = emit_surface(context, out, planned, sides);
    if (surface.nothing) return;
    const PlannedSurface product = with_product(planned, rooted.nodes, traversal.leaves());
    emit_visible(context, out, planned, surface, [&] { return emit_by_levels(context, out, product, all_levels); });
  } while (traversal.next());
}

/// Z1 := "nothing" where E is 0. Then a depth test finds the surface by itself, and there needs to be no bit that says
/// where it is.
void emit_nothing_elsewhere(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  out.origin = {isa::Purpose::stack, planned.primitive(), isa::no_node};
  out.plain(isa::Opcode::enable_invert);
  out.plain(isa::Opcode::set_constant, context.layout.candidate, {}, static_cast<std::uint64_t>(context.farthest()));
}

/// One product after another of a surface that stays in Z1.
void emit_kept_products(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface) {
  emit_admission(context, out, planned);
  emit_nothing_elsewhere(context, out, planned);
  const csg::RootedTree rooted = csg::with_root(planned.active);
  csg::ProductTraversal traversal(rooted.nodes, rooted.root);
  std::size_t after_first_test = 0;
  do {
    const PlannedSurface product = with_product(planned, rooted.nodes, traversal.leaves());
    out.origin = {isa::Purpose::stack, planned.primitive(), isa::no_node};
    out.plain(isa::Opcode::enable_all);
    ++out.counts.depth_tests;
    emit_depth_test(context, out, planned);
    const std::size_t after_test = out.size();
    const bool is_classified = emit_classified(context, out, planned, surface,
                                               [&] { return emit_by_levels(context, out, product, all_levels); });
    if (after_first_test == 0) {
      after_first_test = after_test;
    } else if (is_classified) {
      emit_depth_early_out(context, out, planned, after_test);
    }
  } while (traversal.next());
  // Z2 only gets nearer: what is hidden before the first product is hidden before all.
  emit_depth_early_out(context, out, planned, after_first_test);
  emit_base_early_out(context, out, planned, surface);
}

/// The products of thesis 6.4 with three bits.
void emit_products(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const Surface surface = emit_surface(context, out, planned, sides);
  if (surface.nothing) return;
  if (products_of(planned, context.options) > 1) return emit_kept_products(context, out, planned, surface);
  const csg::RootedTree rooted = csg::with_root(planned.active);
  const csg::ProductTraversal only(rooted.nodes, rooted.root);
  const PlannedSurface product = with_product(planned, rooted.nodes, only.leaves());
  emit_visible(context, out, planned, surface, [&] { return emit_by_levels(context, out, product, all_levels); });
}

/// Bits that working out one active tree takes.
ClassificationBits bits_of_surface(const PlannedSurface& planned, const Options& options) {
  ClassificationBits bits;
  switch (options.strategy) {
    case Strategy::stack:
    case Strategy::stored:
    case Strategy::polygons: return bits_for_levels(planned.active, all_levels);
    case Strategy::list: bits.label = label_bits(planned.active); break;
    case Strategy::bits:
      return merges_each_product(options) ? bits : bits_for_levels(planned.active, stack_levels(options));
    case Strategy::products: break;
    case Strategy::parallel: bits.stack = string_bits(planned.active); break;
    case Strategy::automatic: throw std::logic_error("no strategy was chosen");
  }
  return bits;
}

}  // namespace

ClassificationBits classification_bits(const Drawing& drawing, const Options& options) {
  check_products(*drawing.tree, drawing.plan, options);
  ClassificationBits most;
  for (const SegmentPlan& segment : drawing.plan.segments) {
    ClassificationBits bits;
    for (const PlannedSurface& one : segment.surfaces) bits = most_of(bits, bits_of_surface(one, options));
    if (options.strategy == Strategy::stored) {
      const auto compared = static_cast<unsigned>(compared_primitives(segment, drawing.view).size());
      bits.stored = compared * 2 * drawing.view.sampling.z_bits;
    }
    most = most_of(most, bits);
  }
  return most;
}

void emit_primitive(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const Options& options = context.options;
  if (merges_each_product(options) && !planned.active.operands.empty()) {
    const bool renders_each = options.strategy == Strategy::products;
    return renders_each ? emit_rendered_products(context, out, planned, sides)
                        : emit_products(context, out, planned, sides);
  }
  if (options.strategy == Strategy::polygons) {
    const Surface surface = surface_of(context, planned, sides);
    if (surface.nothing) return;
    if (has_polygons(context, planned, surface)) return emit_polygons(context, out, planned, sides, surface);
  }
  const Surface surface = has_stored_surface(context, planned) ? emit_stored_surface(context, out, planned, sides)
                                                               : emit_surface(context, out, planned, sides);
  if (surface.nothing) return;
  emit_visible(context, out, planned, surface, [&]() -> std::uint64_t {
    if (planned.active.operands.empty()) return 0;
    switch (options.strategy) {
      case Strategy::stack:
      case Strategy::stored:
      case Strategy::polygons: return emit_by_levels(context, out, planned, all_levels);
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
