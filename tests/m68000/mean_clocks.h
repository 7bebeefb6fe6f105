#pragma once

#include "tests/m68000/traversal.h"

namespace csgsim::m68000 {

/// Mean cost of a method's program over a fixed set of random trees of 1 to 20 primitives.
struct MeanClocks {
  double clocks = 0;
  double surfaces = 0;  ///< surfaces that the ray passes; the point on each is classified
  double nodes = 0;     ///< nodes of the tree, summed over these points
};

/// Uses trees of the maximum number of levels for the bits of a long.
MeanClocks mean_clocks(Method method, Written written);

}  // namespace csgsim::m68000
