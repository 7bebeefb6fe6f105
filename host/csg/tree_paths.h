#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/positive_tree.h"

namespace csgsim::csg {

/// What is asked of the paths between the nodes of a tree, prepared once so that no answer takes a walk along a path:
/// the lowest node above two (along heavy paths: Harel and Tarjan 1984), primitives below one, and what a part of the
/// tree is at a place where no primitive of it is. Keeps a reference to the tree.
class TreePaths {
 public:
  explicit TreePaths(const PositiveTree& tree);

  /// The lowest node that has both at or below it.
  [[nodiscard]] std::uint32_t above(std::uint32_t one, std::uint32_t other) const;

  /// The child, at or above the primitive's leaf, of a node that has that leaf below it.
  [[nodiscard]] std::uint32_t child_towards(std::uint32_t node, std::uint32_t primitive) const;

  /// Primitives below a node: numbered from the first to the last, in tree order.
  [[nodiscard]] std::uint32_t first(std::uint32_t node) const { return notes_[node].first; }
  [[nodiscard]] std::uint32_t last(std::uint32_t node) const { return notes_[node].last; }

  /// Whether a place where no primitive of the subtree is, is in the subtree.
  [[nodiscard]] bool in_elsewhere(std::uint32_t node) const { return notes_[node].in_elsewhere; }

  /// Whether that decides what its parent is: out in an intersection, in in a union.
  [[nodiscard]] bool decides_elsewhere(std::uint32_t node) const { return notes_[node].decides; }

  /// How many children decide the node by what they are elsewhere.
  [[nodiscard]] std::uint32_t deciding_children(std::uint32_t node) const { return notes_[node].deciding_children; }

  /// Whether, on the way from `node` up to `top`, without that, a node has a sibling that decides their parent by what
  /// it is elsewhere.
  [[nodiscard]] bool is_decided_between(std::uint32_t node, std::uint32_t top) const {
    return notes_[node].decided_above != notes_[top].decided_above;
  }

  /// The same of those nodes whose parents are intersections.
  [[nodiscard]] bool is_out_between(std::uint32_t node, std::uint32_t top) const {
    return notes_[node].out_above != notes_[top].out_above;
  }

  /// The lowest node, at or above that one, whose parent is an intersection; no_index if there is none.
  [[nodiscard]] std::uint32_t operand_above(std::uint32_t node) const { return notes_[node].operand; }

  /// The topmost intersection above the node; no_index if there is none.
  [[nodiscard]] std::uint32_t top_intersection(std::uint32_t node) const { return notes_[node].top; }

 private:
  struct Note {
    bool in_elsewhere = false;
    bool decides = false;
    std::uint32_t first = model::no_index;
    std::uint32_t last = 0;
    std::uint32_t path = model::no_index;  ///< the topmost node of its heavy path
    std::uint32_t deciding_children = 0;
    std::uint32_t decided_above = 0;  ///< nodes at or above it with a sibling that decides
    std::uint32_t out_above = 0;      ///< those among them whose parent is an intersection
    std::uint32_t operand = model::no_index;
    std::uint32_t top = model::no_index;
  };
  void note_below(std::uint32_t node);
  void note_above(std::uint32_t node, bool is_heavy);

  const PositiveTree& tree_;
  std::vector<Note> notes_;
};

}  // namespace csgsim::csg
