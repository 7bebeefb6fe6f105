#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

namespace csgsim::division {

/// What the divider does for a surface, a square, or a group of squares (docs/division.md has the rules).
struct Counts {
  std::uint64_t boxes = 0;         ///< rectangles of primitives held against the square's or the group's
  std::uint64_t lists = 0;         ///< lists of half-spaces that are read, empty ones left out
  std::uint64_t halfspaces = 0;    ///< corner tests: a half-space at the four corners of a rectangle
  std::uint64_t cells = 0;         ///< cell tests: a half-space of a side held against the leaders of a cell
  std::uint64_t nodes = 0;         ///< of the tree, looked at
  std::uint64_t instructions = 0;  ///< emitted

  Counts& operator+=(const Counts& more) {
    boxes += more.boxes;
    lists += more.lists;
    halfspaces += more.halfspaces;
    cells += more.cells;
    nodes += more.nodes;
    instructions += more.instructions;
    return *this;
  }
  bool operator==(const Counts&) const = default;
};

/// What the divider has to keep at a time, the most for any surface of a square: whatever it looks at for one.
struct AtHand {
  std::uint64_t halfspaces = 0;  ///< tested at corners
  std::uint64_t nodes = 0;       ///< of the tree

  bool operator==(const AtHand&) const = default;
};

/// Of the surfaces that each takes so much.
inline AtHand at_hand_of(std::span<const Counts> surfaces) {
  AtHand most;
  for (const Counts& one : surfaces) {
    most.halfspaces = std::max(most.halfspaces, one.halfspaces);
    most.nodes = std::max(most.nodes, one.nodes);
  }
  return most;
}

}  // namespace csgsim::division
