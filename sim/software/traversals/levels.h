#pragma once

#include <cstdint>
#include <string>

#include "hw/base/error.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Levels of a tree that calls go down, which have the stack of a thread.
inline constexpr std::uint32_t most_calls = 20'000;
inline constexpr std::uint32_t any_levels = 0xffffffffU;

/// Throws InputError for a tree of more levels than that.
inline void refuse_deep(const Tree& tree, std::uint32_t most_levels) {
  if (tree.depth() <= most_levels) return;
  throw InputError("the tree has " + std::to_string(tree.depth()) + " levels, of " + std::to_string(most_levels) +
                   " that this method goes down; take --shapes balanced, or another method");
}

}  // namespace csgsim::software
