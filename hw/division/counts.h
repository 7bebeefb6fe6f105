#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// What the divider does for a surface, a square, or a group of squares.
using Counts = isa::DivisionStep;

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
