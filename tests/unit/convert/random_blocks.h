#pragma once

#include <array>
#include <vector>

#include "host/model/tree.h"
#include "tests/oracle/split_mix.h"

namespace csgsim::testing {

/// Places of boxes are whole numbers from 0 to this.
inline constexpr int box_grid = 6;

struct WholeBox {
  std::array<int, 3> low{};
  std::array<int, 3> high{};
};

/// Boxes at whole places, under a random tree.
struct WholeBoxes {
  model::Tree tree;
  std::vector<WholeBox> boxes;
};

WholeBoxes random_boxes(Random& random, unsigned count);

}  // namespace csgsim::testing
