#include "tests/m68000/developed_tree.h"

#include <algorithm>
#include <stdexcept>

namespace csgsim::m68000 {

namespace {

constexpr std::size_t highest_bit = 31;

std::size_t levels_below(const Tree& tree, std::size_t index) {
  const TreeNode& node = tree.nodes[index];
  if (node.kind == NodeKind::primitive) return 0;
  return 1 + std::max(levels_below(tree, node.left), levels_below(tree, node.right));
}

class Developer {
 public:
  Developer(const Tree& tree, DevelopedTree& developed) : tree_(tree), developed_(developed) {}

  /// Places a node at bit `bit`; its leaves are at most `levels` levels below it.
  void place(std::size_t index, std::size_t levels, std::size_t bit) {
    const TreeNode& node = tree_.nodes[index];
    if (node.kind == NodeKind::primitive) {
      developed_.bits.emplace_back(node.primitive, std::uint32_t{1} << bit);
      // Empty nodes fill the levels down to that of the leaves.
      for (std::size_t level = 1; level <= levels; ++level) invert(level, right_of(level, bit));
      return;
    }
    const std::size_t right = right_of(levels, bit);
    if (node.kind == NodeKind::set_union) invert(levels, bit);
    if (node.kind != NodeKind::intersection) invert(levels, right);
    place(node.left, levels - 1, bit);
    place(node.right, levels - 1, right);
  }

 private:
  static std::size_t right_of(std::size_t level, std::size_t bit) { return bit - (std::size_t{1} << (level - 1)); }
  void invert(std::size_t level, std::size_t bit) { developed_.inverted[level - 1] |= std::uint32_t{1} << bit; }

  const Tree& tree_;
  DevelopedTree& developed_;
};

}  // namespace

std::size_t levels_of(const Tree& tree) { return levels_below(tree, tree.root); }

DevelopedTree develop(const Tree& tree) {
  const std::size_t levels = std::max<std::size_t>(levels_of(tree), 1);
  if (levels > most_levels) throw std::out_of_range("a tree of too many levels for the bits of a long");
  DevelopedTree developed{std::vector<std::uint32_t>(levels), {}};
  Developer(tree, developed).place(tree.root, levels, highest_bit);
  return developed;
}

}  // namespace csgsim::m68000
