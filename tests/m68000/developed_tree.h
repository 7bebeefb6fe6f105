#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/m68000/tree.h"

namespace csgsim::m68000 {

/// Levels of a tree that bits of a long have room for.
inline constexpr std::size_t most_levels = 5;

/// Levels of nodes that are not leaves.
std::size_t levels_of(const Tree& tree);

/// A fully developed tree, for the bit-parallel method (thesis, section 4.4.2).
struct DevelopedTree {
  std::vector<std::uint32_t> inverted;                        ///< of each level, from the leaves up: table 4.7
  std::vector<std::pair<std::uint16_t, std::uint32_t>> bits;  ///< of each primitive
};

/// Of a tree of `most_levels` at most; of one without any a level is made. Throws std::out_of_range.
DevelopedTree develop(const Tree& tree);

}  // namespace csgsim::m68000
