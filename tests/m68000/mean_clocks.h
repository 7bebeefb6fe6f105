#pragma once

#include "tests/m68000/traversal.h"

namespace csgsim::m68000 {

/// What a method's program takes over a fixed set of random trees of 1 to 20 primitives.
struct MeanClocks {
  double clocks = 0;
  double surfaces = 0;  ///< through each the ray goes, and the point there is classified
  double nodes = 0;     ///< of the tree, at each of them
};

/// Uses trees of the maximum number of levels for the bits of a long.
MeanClocks mean_clocks(Method method, Written written);

}  // namespace csgsim::m68000
