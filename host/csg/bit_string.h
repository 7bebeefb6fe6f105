#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/active_tree.h"

namespace csgsim::csg {

/// The bits from `first` on are ANDed with as many from `second` on, in order.
struct Meeting {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  std::uint32_t bits = 0;

  bool operator==(const Meeting&) const = default;
};

/// Works out one level of the tree: some bits are inverted, and then runs of bits meet their siblings.
struct StringLevel {
  std::vector<std::uint32_t> inverted;  ///< positions, ascending: the ones of the pattern P
  std::vector<Meeting> meetings;
};

/// A tree whose nodes are worked out level by level, all of a level at once (bit-parallel evaluation, thesis 4.4.2).
///
/// Every leaf has a bit, which is 1 where Z1 is in its primitive, complemented or not. A node's result is in the place
/// of its first operand, and the siblings of a level lie in the second part of the string, in the order of the first:
/// so one AND of the string with itself, shifted, works out the level. As in table 4.7, unions are intersections of
/// complements: the inversions after one level are one with those before the next. A node without a sibling at its
/// level keeps its place, so no bits stand for what a fully developed tree would have there; but the AND is in several
/// pieces where such nodes lie between others.
struct BitString {
  std::vector<std::uint32_t> leaves;  ///< the node whose classification is at each position
  std::vector<StringLevel> levels;    ///< from the deepest up
  bool inverted = false;              ///< position 0 holds the complement of the result in the end
};

/// Bits of a node's string: its leaves.
std::uint32_t count_leaves(const std::vector<ActiveNode>& nodes, std::uint32_t root);

/// An operator of more than two operands becomes a tree of the least possible depth, halves as equal as can be.
BitString make_bit_string(const std::vector<ActiveNode>& nodes, std::uint32_t root);

}  // namespace csgsim::csg
