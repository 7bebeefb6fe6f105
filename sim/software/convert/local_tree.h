// CSG trees restricted to some primitives.
// Used by division.h, fragments.cpp and side_by_side.cpp.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/csg/tree_paths.h"

namespace csgsim::software::convert {

/// Whether the points just behind and just in front of a plane are inside a solid.
struct SideValues {
  bool behind = false;
  bool before = false;

  bool operator==(const SideValues&) const = default;
};

/// The value of an operand or of a tree on both sides of a plane, if known.
struct Known {
  bool is_known = false;
  SideValues value{};
};

/// The part of a tree that depends on some primitives, in a region without others: each leaf represents one of them.
/// Children precede their parents.
class LocalTree {
 public:
  struct Node {
    enum class Kind : std::uint8_t { unite, intersect, leaf, constant };
    Kind kind = Kind::leaf;
    bool complemented = false;    ///< for a leaf
    SideValues value{};           ///< for a constant
    std::uint32_t operand = 0;    ///< for a leaf: index of the primitive among the given ones
    std::uint32_t parent = none;  ///< none for the root
  };
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Creates the tree of these primitives, given in ascending order.
  LocalTree(const csg::PositiveTree& tree, const csg::TreePaths& paths, std::span<const std::uint32_t> primitives);

  /// The tree reduced by known operands. `may_differ`: per operand, whether its values behind and in front of the plane
  /// may differ.
  [[nodiscard]] LocalTree reduced(std::span<const Known> operands, const std::vector<bool>& may_differ) const;

  /// Replaces the indices of operands: `numbers` maps old to new ones.
  void renumber(std::span<const std::uint32_t> numbers);

  /// Unknown if the value depends on operands; otherwise constant.
  [[nodiscard]] const Known& value() const { return value_; }
  /// Whether the values behind and in front of the plane may differ.
  [[nodiscard]] bool may_differ() const { return may_differ_; }

  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }

 private:
  LocalTree() = default;

  Known value_;
  bool may_differ_ = true;
  std::vector<Node> nodes_;
};

}  // namespace csgsim::software::convert
