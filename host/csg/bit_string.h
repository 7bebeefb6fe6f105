// Bit strings for the bit-parallel evaluation of active trees.
// Used by host/emit.
#pragma once

#include <cstdint>
#include <vector>

#include "host/csg/active_tree.h"

namespace csgsim::csg {

/// An AND of two runs of `bits` bits: each bit from position `first` on with the corresponding one from `second` on.
struct AndRun {
  std::uint32_t first = 0;
  std::uint32_t second = 0;
  std::uint32_t bits = 0;

  bool operator==(const AndRun&) const = default;
};

/// One level of the tree: some bits are inverted, and then runs of bits are ANDed with their siblings.
struct StringLevel {
  std::vector<std::uint32_t> inverted;  ///< positions of the bits to invert, ascending
  std::vector<AndRun> and_runs;
};

/// A tree that is evaluated level by level, all nodes of a level at once (bit-parallel evaluation, thesis 4.4.2).
///
/// Every leaf has a bit, which is 1 where Z1 is in its primitive, complemented or not. A node's result is at the
/// position of its first operand, and the siblings of a level are in the second part of the string, in the order of the
/// first operands, so that one AND of the string with itself, shifted, evaluates the level. As in table 4.7, unions are
/// intersections of complements: the inversions after one level are merged with those before the next. A node without a
/// sibling at its level keeps its position, so no bits are needed for the missing nodes of a full tree; but the AND is
/// split where such nodes lie between others.
struct BitString {
  std::vector<std::uint32_t> leaves;  ///< by position: the node whose classification is there
  std::vector<StringLevel> levels;    ///< from the deepest level up
  bool inverted = false;              ///< position 0 finally holds the complement of the result
};

/// Number of leaves below a node, which is the length in bits of its string.
std::uint32_t count_leaves(const std::vector<ActiveNode>& nodes, std::uint32_t root);

/// The bit string of the tree below `root`. An operator with more than two operands becomes a tree of minimum depth
/// with balanced halves.
BitString make_bit_string(const std::vector<ActiveNode>& nodes, std::uint32_t root);

}  // namespace csgsim::csg
