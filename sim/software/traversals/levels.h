// Limits on the depth of trees.
// Used by the traversals.
#pragma once

#include <cstdint>
#include <string>

#include "hw/base/error.h"
#include "sim/software/tree/tree.h"

namespace csgsim::software {

/// Maximum number of tree levels for recursion on a thread's stack.
inline constexpr std::uint32_t max_calls = 20'000;
inline constexpr std::uint32_t any_levels = 0xffffffffU;

/// Throws InputError if the tree has more levels.
inline void refuse_deep(const Tree& tree, std::uint32_t max_levels) {
  if (tree.depth() <= max_levels) return;
  throw InputError("the tree has " + std::to_string(tree.depth()) + " levels, but this method supports at most " +
                   std::to_string(max_levels) + "; use --shapes balanced or another method");
}

}  // namespace csgsim::software
