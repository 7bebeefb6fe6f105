// Precomputed queries about paths in a CSG tree.
// Used by the pruner and sim/software/convert.
#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/positive_tree.h"

namespace csgsim::csg {

/// Queries about the paths between the nodes of a tree, precomputed so that no query visits all nodes of a path: the
/// lowest common ancestor (along heavy paths: Harel and Tarjan 1984), the primitives below a node, and the value of a
/// part of the tree at places outside all its primitives. Keeps a reference to the tree.
class TreePaths {
 public:
  explicit TreePaths(const PositiveTree& tree);

  /// The lowest node that has both nodes at or below it.
  [[nodiscard]] std::uint32_t common_ancestor(std::uint32_t first_node, std::uint32_t second_node) const;

  /// The child of `node` at or above the primitive's leaf, which must be below `node`.
  [[nodiscard]] std::uint32_t child_towards(std::uint32_t node, std::uint32_t primitive) const;

  /// Range of the primitives below a node, in tree order: the first and the last.
  [[nodiscard]] std::uint32_t first(std::uint32_t node) const { return notes_[node].first; }
  [[nodiscard]] std::uint32_t last(std::uint32_t node) const { return notes_[node].last; }

  /// Whether a place outside all primitives of the subtree is inside the subtree.
  [[nodiscard]] bool is_inside_elsewhere(std::uint32_t node) const { return notes_[node].is_inside_elsewhere; }

  /// Whether that value decides the parent: outside in an intersection, inside in a union.
  [[nodiscard]] bool decides_elsewhere(std::uint32_t node) const { return notes_[node].decides; }

  /// Number of children that decide the node by their value elsewhere.
  [[nodiscard]] std::uint32_t deciding_children(std::uint32_t node) const { return notes_[node].deciding_children; }

  /// Whether a node on the way from `node` up to, but excluding, `top` has a sibling that decides their parent by its
  /// value elsewhere.
  [[nodiscard]] bool is_decided_between(std::uint32_t node, std::uint32_t top) const {
    return notes_[node].decided_above != notes_[top].decided_above;
  }

  /// As is_decided_between(), but only by siblings in intersections, which decide that nothing is inside.
  [[nodiscard]] bool is_out_between(std::uint32_t node, std::uint32_t top) const {
    return notes_[node].out_above != notes_[top].out_above;
  }

  /// The lowest node at or above `node` whose parent is an intersection; no_index if there is none.
  [[nodiscard]] std::uint32_t operand_above(std::uint32_t node) const { return notes_[node].operand; }

  /// The topmost intersection above the node; no_index if there is none.
  [[nodiscard]] std::uint32_t top_intersection(std::uint32_t node) const { return notes_[node].top; }

 private:
  struct Note {
    bool is_inside_elsewhere = false;
    bool decides = false;
    std::uint32_t first = model::no_index;
    std::uint32_t last = 0;
    std::uint32_t path = model::no_index;  ///< the topmost node of its heavy path
    std::uint32_t deciding_children = 0;
    std::uint32_t decided_above = 0;  ///< number of nodes at or above this one with a deciding sibling
    std::uint32_t out_above = 0;      ///< number of those whose parent is an intersection
    std::uint32_t operand = model::no_index;
    std::uint32_t top = model::no_index;
  };
  void note_below(std::uint32_t node);
  void note_above(std::uint32_t node, bool is_heavy);

  const PositiveTree& tree_;
  std::vector<Note> notes_;
};

}  // namespace csgsim::csg
