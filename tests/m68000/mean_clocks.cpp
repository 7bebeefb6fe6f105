#include "tests/m68000/mean_clocks.h"

#include "tests/m68000/developed_tree.h"
#include "tests/m68000/random_tree.h"

namespace csgsim::m68000 {

MeanClocks mean_clocks(Method method, Written written) {
  constexpr std::uint32_t seeds = 400;
  constexpr std::size_t most_primitives = 20;
  MeanClocks sum;
  for (std::uint32_t seed = 0; seed < seeds; ++seed) {
    const RandomTree random(seed, most_primitives);
    if (levels_of(random.tree()) > most_levels) continue;
    M68000Traversal traversal(method, written);
    traversal.load(random.tree());
    for (const std::uint16_t primitive : random.flips()) {
      traversal.flip(primitive);
      traversal.evaluate();
    }
    sum.clocks += static_cast<double>(traversal.clocks());
    sum.surfaces += static_cast<double>(random.flips().size());
    sum.nodes += static_cast<double>(random.flips().size() * random.tree().nodes.size());
  }
  return sum;
}

}  // namespace csgsim::m68000
