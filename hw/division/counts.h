#pragma once

#include <cstdint>

namespace csgsim::division {

/// What the divider does for a square, or for a group of squares (docs/division.md has the rules).
struct Counts {
  std::uint64_t boxes = 0;         ///< rectangles of primitives held against the square's or the group's
  std::uint64_t halfspaces = 0;    ///< corner tests: a half-space at the four corners of a rectangle
  std::uint64_t pairs = 0;         ///< half-spaces of a side held against each other
  std::uint64_t nodes = 0;         ///< of the tree, looked at
  std::uint64_t instructions = 0;  ///< emitted

  Counts& operator+=(const Counts& more) {
    boxes += more.boxes;
    halfspaces += more.halfspaces;
    pairs += more.pairs;
    nodes += more.nodes;
    instructions += more.instructions;
    return *this;
  }
  bool operator==(const Counts&) const = default;
};

}  // namespace csgsim::division
