#include <rapidcheck.h>

#include "host/read/read.h"
#include "sim/software/convert/surface.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/split_mix.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/test.h"
#include "tests/unit/convert/converted.h"
#include "tests/unit/convert/mesh_judge.h"
#include "tests/unit/convert/random_blocks.h"

using namespace csgsim;
using testing::Random;

namespace {

/// Whether the unit cube at that position is in the solid.
bool is_full(const testing::WholeBoxes& made, const testing::TreeRules& rules, const std::array<int, 3>& at) {
  std::vector<bool> held;
  for (const testing::WholeBox& block : made.boxes) {
    bool is_in = true;
    for (std::size_t axis = 0; axis < 3; ++axis)
      is_in = is_in && block.low[axis] <= at[axis] && at[axis] < block.high[axis];
    held.push_back(is_in);
  }
  return rules.holds(held);
}

struct Counted {
  int volume = 0;
  int area = 0;
};

Counted count_cubes(const testing::WholeBoxes& made) {
  const testing::TreeRules rules(made.tree);
  Counted counted;
  for (int x = 0; x <= testing::box_grid; ++x) {
    for (int y = 0; y <= testing::box_grid; ++y) {
      for (int z = 0; z <= testing::box_grid; ++z) {
        const bool is_in = is_full(made, rules, {x, y, z});
        if (is_in) ++counted.volume;
        if (is_in != is_full(made, rules, {x - 1, y, z})) ++counted.area;
        if (is_in != is_full(made, rules, {x, y - 1, z})) ++counted.area;
        if (is_in != is_full(made, rules, {x, y, z - 1})) ++counted.area;
      }
    }
  }
  return counted;
}

}  // namespace

TEST_CASE("integer boxes convert to closed meshes of exactly the tree's unit cubes") {
  int full = 0;
  CHECK(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    const testing::WholeBoxes made = testing::random_boxes(random, 2 + static_cast<unsigned>(random.below(12)));
    const software::convert::Surface surface = testing::converted(made.tree);
    const Counted counted = count_cubes(made);
    RC_ASSERT(testing::fault_of(testing::judged(surface)) == "");
    const software::convert::Measures measures = software::convert::measure(surface);
    RC_ASSERT(std::abs(measures.volume - counted.volume) < 1e-9);
    RC_ASSERT(std::abs(measures.area - counted.area) < 1e-9);
    if (counted.volume > 0) ++full;
  }));
  if (testing::draws_usual_cases()) CHECK(full > 50);
}

TEST_CASE("random solids with coincident faces convert to closed meshes") {
  int inside = 0;
  CHECK(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    const std::string text = testing::random_model(seed, 2 + static_cast<unsigned>(random.below(7)));
    const model::Tree tree = read::read_csg_text(text, "random.csg");
    if (tree.root == model::no_index) return;
    const testing::JudgedMesh mesh = testing::judged(testing::converted(tree));
    RC_ASSERT(testing::fault_of(mesh) == "");
    std::mt19937_64 points(seed);
    std::uniform_real_distribution<double> place(-4, 4);
    for (int i = 0; i < 180; ++i) {
      const glm::dvec3 point(place(points), place(points), place(points));
      const testing::Held held = testing::held_by(tree, point, 1e-6);
      if (held == testing::Held::unsure) continue;
      RC_ASSERT(testing::winding(mesh, point) == (held == testing::Held::in ? 1 : 0));
      if (held == testing::Held::in) ++inside;
    }
  }));
  if (testing::draws_usual_cases()) CHECK(inside > 200);
}
