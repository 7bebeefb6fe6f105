#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "host/csg/box_index.h"
#include "host/csg/convex_sets.h"
#include "host/csg/counted.h"
#include "host/csg/hull.h"
#include "host/csg/locate.h"
#include "host/csg/positive_tree.h"
#include "host/csg/pruning.h"
#include "host/csg/tree_paths.h"
#include "host/facet/geometry.h"
#include "host/view/projection.h"

namespace csgsim::csg {

/// A node of an active tree. Children precede their parents; the neediest operand stands first, so that evaluating from
/// left to right holds the fewest results at a time. No operand of an operator has the same operator.
struct ActiveNode {
  bool is_leaf = false;
  bool complemented = false;  ///< leaf: the space outside the intersection of its primitives
  PositiveOperator op = PositiveOperator::unite;
  std::uint32_t primitive = model::no_index;
  std::uint32_t bits = 0;  ///< results to hold while this node is worked out into one of them; 0 for a leaf
  std::vector<std::uint32_t> children;
  std::vector<std::uint32_t> others;  ///< leaf: primitives besides the first whose intersection it is

  /// How many primitives the leaf stands for.
  [[nodiscard]] std::uint32_t primitives() const { return 1 + static_cast<std::uint32_t>(others.size()); }
};

/// What is left of a primitive's I-tree (thesis 6.2) over its block: the intersection of `operands`. The primitive's
/// surface is visible where it is in all of them. Without operands it is visible everywhere in the block.
struct ActiveTree {
  bool nothing = false;  ///< the surface is out everywhere in the block
  std::vector<ActiveNode> nodes;
  std::vector<std::uint32_t> operands;  ///< indices into nodes

  /// Results to hold besides the one that stands for the primitive itself.
  [[nodiscard]] std::uint32_t bits() const;

  /// Levels of the tree: 0 without operands, 1 for a leaf.
  [[nodiscard]] std::uint32_t depth() const;
};

/// Prunes I-trees for regions of the picture. Keeps references to its arguments; for one thread.
///
/// An index of boxes finds the primitives that may meet the block. Only the parts of an I-tree that have some of these
/// are visited; the other parts are known, as they are the same wherever none of their primitives is.
class Pruner {
 public:
  Pruner(const facet::Geometry& geometry, const view::View& view, const PositiveTree& tree, const Pruning& pruning = {},
         const Counted& counted = {});

  /// The part of the region and the depths that the surface of a set can be in; its pixels are empty if there are none.
  [[nodiscard]] Block block_of(std::span<const std::uint32_t> set, const view::PixelRect& region) const;

  /// Over a block of the set's, which has pixels.
  [[nodiscard]] ActiveTree active_tree(std::span<const std::uint32_t> set, const Block& block) const;

  /// The primitives of the set's I-tree that may meet the block: the others are disjoint from it by the prunings
  /// `picture` and `space`. In tree order; some that are not of the I-tree may be among them.
  [[nodiscard]] std::vector<std::uint32_t> meeting(std::span<const std::uint32_t> set, const Block& block) const;

 private:
  struct Pruned;
  class Walk;
  /// Where a set's surface is looked at.
  struct Place {
    Block block;
    std::span<const std::uint32_t> set;
  };
  using Primitives = std::span<const std::uint32_t>;
  [[nodiscard]] bool disjoint(std::uint32_t primitive, const Place& place) const;
  [[nodiscard]] Hull& hull(std::uint32_t primitive) const;
  [[nodiscard]] bool separated(std::uint32_t one, std::uint32_t other) const;
  [[nodiscard]] Known leaf_known(const PositiveNode& leaf, const Place& place) const;
  [[nodiscard]] Known known(const PositiveNode& leaf, const Place& place) const;
  [[nodiscard]] Primitives below(std::uint32_t node, Primitives from) const;
  [[nodiscard]] bool is_decided_elsewhere(std::uint32_t node, Primitives meeting) const;
  [[nodiscard]] bool add_operands(std::uint32_t node, Primitives meeting, const Place& place, ActiveTree& into) const;
  void join_leaves(ActiveTree& into, PositiveOperator op, std::vector<std::uint32_t>& operands) const;
  void find(std::uint32_t first, std::uint32_t end, const Place& place, std::vector<std::uint32_t>& found) const;

  const facet::Geometry& geometry_;
  const view::View& view_;
  const PositiveTree& tree_;
  Pruning pruning_;
  Counted counted_;
  TreePaths paths_;
  /// Which pairs are, as far as they have been asked for: every region would find the same.
  mutable std::unordered_map<std::uint64_t, bool> separated_;
  mutable std::unordered_map<std::uint32_t, Hull> hulls_;  ///< of primitives, as far as they have been asked for
  std::optional<BoxIndex> boxes_;  ///< of the primitives, by pixels, depths and number; if picture pruning is asked for
};

}  // namespace csgsim::csg
