#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/m68000/tree.h"

namespace csgsim::m68000 {

/// Number of tree levels that fit into the bits of a long.
inline constexpr std::size_t most_levels = 5;

/// Number of levels of inner nodes.
std::size_t levels_of(const Tree& tree);

/// A fully developed tree, for the bit-parallel method (thesis, section 4.4.2).
struct DevelopedTree {
  std::vector<std::uint32_t> inverted;                        ///< by level, from the leaves up: table 4.7
  std::vector<std::pair<std::uint16_t, std::uint32_t>> bits;  ///< number and bit of each primitive
};

/// Develops a tree of at most `most_levels` levels, and at least one. Throws std::out_of_range.
DevelopedTree develop(const Tree& tree);

}  // namespace csgsim::m68000
