#include "host/csg/products.h"

#include <algorithm>
#include <vector>

#include "host/csg/separation.h"
#include "host/emit/evaluation.h"
#include "host/emit/levels.h"
#include "host/emit/strategy.h"
#include "hw/isa/opcodes.h"

namespace csgsim::emit {

namespace {

/// Number of levels that `Strategy::bits` evaluates with a stack: m bits minus those for front, back, product and sum,
/// as in figure 6.3 of the thesis (the text of 6.4 says m - 3). Not for m = 3, which has no sum.
unsigned stack_levels(const Options& options) { return options.stack_bits - min_stack_bits - 1; }

/// Whether a primitive is merged product by product, because there is no bit to sum them in.
bool merges_each_product(const Options& options) { return options.stack_bits == min_stack_bits; }

std::uint64_t all_products(const csg::ActiveTree& active) {
  const csg::RootedTree rooted = csg::make_rooted_tree(active);
  return csg::count_products(rooted.nodes)[rooted.root];
}

/// The surface with the leaves of one product as its active tree.
PlannedSurface with_product(const PlannedSurface& planned, const std::vector<csg::ActiveNode>& nodes,
                            std::vector<std::uint32_t> leaves) {
  PlannedSurface product{planned.set, planned.block, {}, planned.number};
  product.active.nodes = nodes;
  product.active.operands = std::move(leaves);
  return product;
}

/// Whether a plane separates two primitives; false if the search is not worth its time.
bool are_apart(const Context& context, std::uint32_t one, std::uint32_t other) {
  if (!context.options.pruning.separation) return false;
  const facet::Geometry& geometry = context.geometry;
  const auto halfspaces = geometry.solids[one].halfspaces.size() + geometry.solids[other].halfspaces.size();
  csg::PairTable& pairs = *context.plan.pairs;
  const csg::Prices& prices = context.options.prices;
  return prices.is_worthwhile(static_cast<double>(halfspaces), pairs.price(one, other, prices)) &&
         pairs.are_apart(one, other, context.view, context.counted);
}

/// A product is empty if two of its solids are disjoint (thesis 6.3.2).
bool is_empty(const Context& context, const std::vector<csg::ActiveNode>& nodes,
              const std::vector<std::uint32_t>& leaves) {
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      const csg::ActiveNode& a = nodes[leaves[i]];
      const csg::ActiveNode& b = nodes[leaves[j]];
      if (a.complemented || b.complemented) continue;
      if (csg::disjoint(context.view, a.primitive, b.primitive, context.options.pruning, context.counted) ||
          are_apart(context, a.primitive, b.primitive)) {
        return true;
      }
    }
  }
  return false;
}

/// The non-empty products of thesis 6.3: each is rendered, classified and merged.
void emit_rendered_products(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const csg::RootedTree rooted = csg::make_rooted_tree(planned.active);
  csg::ProductTraversal traversal(rooted.nodes, rooted.root);
  do {
    if (is_empty(context, rooted.nodes, traversal.leaves())) continue;
    const Surface surface = emit_surface(context, out, planned, sides);
    if (surface.nothing) return;
    const PlannedSurface product = with_product(planned, rooted.nodes, traversal.leaves());
    emit_visible(context, out, planned, surface, {emit_by_all_levels, product});
  } while (traversal.next());
}

/// Z1 := the farthest depth where E is 0. The depth test then excludes these pixels, and no bit has to mark the
/// surface.
void emit_nothing_elsewhere(const Context& context, Broadcast& out, const PlannedSurface& planned) {
  out.origin = {isa::Purpose::stack, planned.primitive(), isa::no_node};
  out.plain(isa::Opcode::enable_invert);
  out.plain(isa::Opcode::set_constant, context.layout.candidate, {}, static_cast<std::uint64_t>(context.farthest()));
}

/// Classifies and merges one product after another, while the surface stays in Z1.
void emit_kept_products(const Context& context, Broadcast& out, const PlannedSurface& planned, const Surface& surface) {
  emit_admission(context, out, planned);
  emit_nothing_elsewhere(context, out, planned);
  const csg::RootedTree rooted = csg::make_rooted_tree(planned.active);
  csg::ProductTraversal traversal(rooted.nodes, rooted.root);
  std::size_t after_first_test = 0;
  do {
    const PlannedSurface product = with_product(planned, rooted.nodes, traversal.leaves());
    out.origin = {isa::Purpose::stack, planned.primitive(), isa::no_node};
    out.plain(isa::Opcode::enable_all);
    ++out.counts.depth_tests;
    emit_depth_test(context, out, planned);
    const std::size_t after_test = out.size();
    const bool is_classified = emit_classified(context, out, planned, surface, {emit_by_all_levels, product});
    if (after_first_test == 0) {
      after_first_test = after_test;
    } else if (is_classified) {
      emit_depth_early_out(context, out, planned, after_test);
    }
  } while (traversal.next());
  // Z2 only gets nearer: pixels hidden before the first product stay hidden.
  emit_depth_early_out(context, out, planned, after_first_test);
  emit_base_early_out(context, out, planned, surface);
}

/// The products of thesis 6.4 with three bits.
void emit_products(const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
  const Surface surface = emit_surface(context, out, planned, sides);
  if (surface.nothing) return;
  if (all_products(planned.active) > 1) return emit_kept_products(context, out, planned, surface);
  const csg::RootedTree rooted = csg::make_rooted_tree(planned.active);
  const csg::ProductTraversal only(rooted.nodes, rooted.root);
  const PlannedSurface product = with_product(planned, rooted.nodes, only.leaves());
  emit_visible(context, out, planned, surface, {emit_by_all_levels, product});
}

}  // namespace

/// Thesis 6.4: the first levels with a stack, the subtrees below by repeated traversal.
extern const StrategyRow bits_strategy{
    .bits =
        [](const csg::ActiveTree& active, const Options& options) {
          return merges_each_product(options) ? ClassificationBits{} : bits_for_levels(active, stack_levels(options));
        },
    .classify =
        [](const Context& context, Broadcast& out, const PlannedSurface& planned) {
          return emit_by_levels(context, out, planned, stack_levels(context.options));
        },
    .draw =
        [](const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
          if (!merges_each_product(context.options) || planned.active.operands.empty()) return false;
          emit_products(context, out, planned, sides);
          return true;
        },
    .products =
        [](const csg::ActiveTree& active, const Options& options) {
          return merges_each_product(options) ? all_products(active)
                                              : products_below_levels(active, stack_levels(options));
        },
    .has_stack_bits = true};

/// Thesis 6.3: sum of products, with each primitive rendered once per product. Chapter 6 expands the tree of primitives
/// without simplification.
extern const StrategyRow products_strategy{
    .bits = [](const csg::ActiveTree& /*active*/, const Options& /*options*/) { return ClassificationBits{}; },
    .draw =
        [](const Context& context, Broadcast& out, const PlannedSurface& planned, const Sides& sides) {
          if (planned.active.operands.empty()) return false;
          emit_rendered_products(context, out, planned, sides);
          return true;
        },
    .products = [](const csg::ActiveTree& active, const Options& /*options*/) { return all_products(active); },
    .takes_sets = false,
    .is_tried = false};

}  // namespace csgsim::emit
