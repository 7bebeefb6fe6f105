#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "host/csg/positive_tree.h"
#include "host/csg/tree_paths.h"

namespace csgsim::software::convert {

/// Whether a point just behind a plane is in a solid, and one just before it.
struct Both {
  bool behind = false;
  bool before = false;

  bool operator==(const Both&) const = default;
};

/// What is known of an operand.
struct Known {
  bool is_known = false;
  Both value{};
};

/// The part of a tree that depends on some primitives, where no others are: each of its leaves stands for one of those.
/// Nodes come before their parents.
class LocalTree {
 public:
  struct Node {
    enum class Kind : std::uint8_t { unite, intersect, leaf, constant };
    Kind kind = Kind::leaf;
    bool complemented = false;    ///< leaf
    Both value{};                 ///< constant
    std::uint32_t operand = 0;    ///< leaf: number of the primitive among the given ones
    std::uint32_t parent = none;  ///< none of the root
  };
  static constexpr std::uint32_t none = 0xffffffffU;

  /// Of these primitives, ascending.
  LocalTree(const csg::PositiveTree& tree, const csg::TreePaths& paths, std::span<const std::uint32_t> primitives);

  /// What is left where some operands are known. `may_differ`: of each operand, whether it can yet be other behind the
  /// plane than before it.
  [[nodiscard]] LocalTree reduced(std::span<const Known> operands, const std::vector<bool>& may_differ) const;

  /// The same with operands of other numbers: `numbers` has the new one of each.
  void renumber(std::span<const std::uint32_t> numbers);

  /// None if the value depends on operands; else it is the same wherever they are.
  [[nodiscard]] const Known& value() const { return value_; }
  /// Whether the value behind the plane and before it may differ.
  [[nodiscard]] bool may_differ() const { return may_differ_; }

  [[nodiscard]] std::span<const Node> nodes() const { return nodes_; }

 private:
  LocalTree() = default;

  Known value_;
  bool may_differ_ = true;
  std::vector<Node> nodes_;
};

}  // namespace csgsim::software::convert
