#include "tests/unit/convert/random_blocks.h"

#include <cstddef>

#include "tests/unit/software/random_tree.h"

namespace csgsim::testing {

WholeBoxes random_boxes(Random& random, unsigned count) {
  WholeBoxes made{random_tree(random, count), {}};
  for (model::Primitive& primitive : made.tree.primitives) {
    WholeBox box;
    glm::dvec3 size(0);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const auto low = static_cast<int>(random.below(box_grid));
      const auto side = 1 + static_cast<int>(random.below(static_cast<unsigned>(box_grid - low)));
      box.low[axis] = low;
      box.high[axis] = low + side;
      size[static_cast<int>(axis)] = side;
      primitive.transform[3][static_cast<int>(axis)] = low;
    }
    primitive.shape = model::Cube{size, false};
    made.boxes.push_back(box);
  }
  return made;
}

}  // namespace csgsim::testing
