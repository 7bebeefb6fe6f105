#pragma once

#include <array>
#include <vector>

#include "host/model/tree.h"
#include "tests/oracle/split_mix.h"

namespace csgsim::testing {

/// Box coordinates are integers from 0 to this value.
inline constexpr int box_grid = 6;

struct WholeBox {
  std::array<int, 3> low{};
  std::array<int, 3> high{};
};

/// Boxes with integer coordinates under a random tree.
struct WholeBoxes {
  model::Tree tree;
  std::vector<WholeBox> boxes;
};

WholeBoxes random_boxes(Random& random, unsigned count);

}  // namespace csgsim::testing
