// Active trees: CSG trees pruned for a block of picture and depth.
// Used by host/emit.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "host/csg/box_index.h"
#include "host/csg/convex_sets.h"
#include "host/csg/counted.h"
#include "host/csg/locate.h"
#include "host/csg/pair_table.h"
#include "host/csg/positive_tree.h"
#include "host/csg/prices.h"
#include "host/csg/pruning.h"
#include "host/csg/tree_paths.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"

namespace csgsim::csg {

/// A node of an active tree. Children precede their parents. The operand that needs the most results comes first, so
/// that evaluation from left to right holds as few results as possible. No operand of an operator has the same
/// operator.
struct ActiveNode {
  bool is_leaf = false;
  bool complemented = false;  ///< leaf: the space outside the intersection of its primitives
  PositiveOperator op = PositiveOperator::unite;
  std::uint32_t primitive = model::no_index;
  std::uint32_t bits = 0;  ///< number of results to hold while this node is evaluated to a result; 0 for a leaf
  std::vector<std::uint32_t> children;
  std::vector<std::uint32_t> others;  ///< leaf: primitives intersected with `primitive`

  /// Number of primitives of the leaf.
  [[nodiscard]] std::uint32_t primitives() const { return 1 + static_cast<std::uint32_t>(others.size()); }
};

/// The remainder of a primitive's I-tree (thesis 6.2) over its block: the intersection of `operands`. The primitive's
/// surface is visible where it is inside all of them. Without operands it is visible everywhere in the block.
struct ActiveTree {
  bool nothing = false;  ///< the surface is outside everywhere in the block
  std::vector<ActiveNode> nodes;
  std::vector<std::uint32_t> operands;  ///< indices into nodes

  /// Number of results to hold in addition to that of the primitive itself.
  [[nodiscard]] std::uint32_t bits() const;

  /// Number of levels of the tree: 0 without operands, 1 for a leaf.
  [[nodiscard]] std::uint32_t depth() const;
};

/// Statistics of a pruning; members as in isa::PruningFacts.
struct Tally {
  std::uint64_t tried = 0;
  std::uint64_t decided = 0;
  std::uint64_t left = 0;
  double saved = 0;
  double nanoseconds = 0;

  /// Records an item to which the pruning was applied.
  void add(bool is_decided, double saved_instructions, double spent_nanoseconds) {
    ++tried;
    nanoseconds += spent_nanoseconds;
    if (!is_decided) return;
    ++decided;
    saved += saved_instructions;
  }
};

/// The tallies of the prunings that are applied item by item.
struct Tallies {
  Tally space;
  Tally separation;
  Tally halfspaces;
  Tally hidden;
};

class KeptResults;

/// Inputs of pruning in addition to the model and the view.
struct PrunerSettings {
  Pruning pruning{};
  Prices prices{};
  Counted counted{};            ///< counts the work for a view
  KeptResults* kept = nullptr;  ///< results of earlier blocks and frames, to which new ones are added; null: none are
                                ///< kept
};

/// Prunes I-trees for regions of the picture. `pairs` has the results for pairs of primitives of the geometry. The
/// pruner keeps references to its arguments and is not thread-safe.
///
/// An index of boxes finds the primitives that may meet the block. Only the parts of an I-tree that contain some of
/// these are visited; the values of the other parts are precomputed, as they do not depend on the block.
class Pruner {
 public:
  Pruner(const facet::Geometry& geometry, const view::View& view, const PositiveTree& tree, PairTable& pairs,
         const PrunerSettings& settings = {});

  /// Statistics of each pruning since construction.
  [[nodiscard]] const Tallies& tallies() const { return tallies_; }

  /// The part of the region and the depths in which the surface of a set can be; its pixels are empty if there is none.
  [[nodiscard]] Block surface_block(std::span<const std::uint32_t> set, const view::PixelRect& region) const;

  /// The active tree over a block of the set, which must have pixels.
  [[nodiscard]] ActiveTree active_tree(std::span<const std::uint32_t> set, const Block& block) const;

  /// The primitives, in tree order, of the set's I-tree that the prunings `picture` and `space` do not prove disjoint
  /// from the block. The result may contain primitives that are not in the I-tree.
  [[nodiscard]] std::vector<std::uint32_t> meeting(std::span<const std::uint32_t> set, const Block& block) const;

 private:
  struct Pruned;
  class Traversal;
  struct SurfaceQuery;
  using Primitives = std::span<const std::uint32_t>;
  [[nodiscard]] bool disjoint(std::uint32_t primitive, const SurfaceQuery& query) const;
  [[nodiscard]] double comparison_instructions(std::uint32_t primitive) const;
  [[nodiscard]] bool have_disjoint_boxes(std::uint32_t first, std::uint32_t second) const;
  [[nodiscard]] bool are_apart(std::uint32_t first, std::uint32_t second) const;
  [[nodiscard]] Containment locate_primitive(std::uint32_t primitive, const SurfaceQuery& query) const;
  [[nodiscard]] Containment locate_leaf(const PositiveNode& leaf, const SurfaceQuery& query) const;
  [[nodiscard]] Containment known(const PositiveNode& leaf, const SurfaceQuery& query) const;
  void visit() const;
  [[nodiscard]] Primitives below(std::uint32_t node, Primitives primitives) const;
  [[nodiscard]] bool is_decided_elsewhere(std::uint32_t node, Primitives meeting) const;
  [[nodiscard]] bool add_operands(std::uint32_t node, Primitives meeting, const SurfaceQuery& query,
                                  ActiveTree& into) const;
  void join_leaves(ActiveTree& into, PositiveOperator op, std::vector<std::uint32_t>& operands) const;
  void find(std::uint32_t first, std::uint32_t end, const SurfaceQuery& query, std::vector<std::uint32_t>& found) const;
  [[nodiscard]] ActiveTree build_active_tree(const SurfaceQuery& query, std::vector<std::uint32_t> found) const;

  const facet::Geometry& geometry_;
  const view::View& view_;
  const PositiveTree& tree_;
  Pruning pruning_;
  Prices prices_;
  Counted counted_;
  TreePaths paths_;
  PairTable& pairs_;
  KeptResults* kept_;
  mutable Tallies tallies_;
  mutable std::uint64_t visits_ = 0;  ///< node visits of all traversals
  std::optional<BoxIndex> boxes_;     ///< index of the primitives by pixels, depths and number; empty without picture
                                      ///< pruning
};

}  // namespace csgsim::csg
