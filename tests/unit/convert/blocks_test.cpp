#include "sim/software/convert/blocks.h"

#include <doctest/doctest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "host/facet/solid.h"
#include "host/read/read.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/split_mix.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/error_of.h"
#include "tests/support/usual_cases.h"
#include "tests/unit/convert/random_blocks.h"

using namespace csgsim;
namespace convert = software::convert;
using testing::Random;

namespace {

/// A tree's solids, of which a point on a face counts as moved along x, then y, then z.
class PointJudge {
 public:
  explicit PointJudge(const model::Tree& tree) : rules_(tree) {
    for (const model::Primitive& primitive : tree.primitives) solids_.push_back(facet::make_solid(primitive));
  }

  [[nodiscard]] bool holds(const glm::dvec3& point) const {
    std::vector<bool> held;
    for (const facet::Solid& solid : solids_)
      held.push_back(std::ranges::all_of(solid.faces, [&](const facet::Face& face) { return is_behind(face, point); }));
    return rules_.holds(held);
  }

 private:
  static bool is_behind(const facet::Face& face, const glm::dvec3& point) {
    const double height = face.plane.height(point);
    if (std::abs(height) > 1e-9) return height < 0;
    for (int axis = 0; axis < 3; ++axis)
      if (std::abs(face.plane.normal[axis]) > 1e-9) return face.plane.normal[axis] < 0;
    return false;
  }

  testing::TreeRules rules_;
  std::vector<facet::Solid> solids_;
};

/// The first cell that is not what its middle is; nothing if there is none.
std::string wrong_cell(const model::Tree& tree, const convert::Bintree& bintree) {
  const PointJudge judge(tree);
  const std::vector<bool> cells = convert::cells_of(bintree);
  const std::size_t n = bintree.resolution;
  for (std::size_t z = 0; z < n; ++z) {
    for (std::size_t y = 0; y < n; ++y) {
      for (std::size_t x = 0; x < n; ++x) {
        const glm::dvec3 middle = bintree.low + (glm::dvec3(x, y, z) + 0.5) * bintree.cell();
        if (judge.holds(middle) != cells[(z * n + y) * n + x])
          return std::to_string(x) + "," + std::to_string(y) + "," + std::to_string(z);
      }
    }
  }
  return "";
}

}  // namespace

TEST_CASE(
    "a cell is what its middle is, whole places and rotated solids alike, and blocks are as large as they can be") {
  int full = 0;
  CHECK(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    const auto count = 2 + static_cast<unsigned>(random.below(8));
    const model::Tree tree = random.below(2) == 0 ? testing::random_boxes(random, count).tree
                                                  : read::read_csg_text(testing::random_model(seed, count), "m.csg");
    const std::uint32_t resolution = random.one_of({2U, 4U, 8U, 16U});
    const convert::Bintree bintree = convert::blocks(tree, resolution);
    if (tree.root != model::no_index) RC_ASSERT(wrong_cell(tree, bintree) == "");
    // A code made of cells alone joins all that is alike.
    RC_ASSERT(convert::code_of(convert::cells_of(bintree), resolution) == bintree.code);
    const convert::BlockCounts counts = convert::count_blocks(bintree);
    const std::vector<bool> cells = convert::cells_of(bintree);
    RC_ASSERT(counts.cells == static_cast<std::uint64_t>(std::ranges::count(cells, true)));
    RC_ASSERT(counts.blocks == static_cast<std::uint64_t>(std::ranges::count(bintree.code, '0') +
                                                          std::ranges::count(bintree.code, '1')));
    if (counts.full > 0) ++full;
  }));
  if (testing::draws_usual_cases()) CHECK(full > 30);
}

TEST_CASE("the code of a cube is one block, and of its lower half along x two") {
  CHECK(convert::blocks(read::read_csg_text("cube([4,4,4]);", "m.csg"), 4).code == "1");
  const std::string half =
      "difference(){cube([4,4,4]);multmatrix([[1,0,0,2],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){"
      "cube([4,4,4]);}}cube([0.1,0.1,0.1]);"
      "multmatrix([[1,0,0,3.9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube([0.1,0.1,0.1]);}";
  CHECK(convert::blocks(read::read_csg_text(half, "m.csg"), 2).code == "(10");
}

TEST_CASE("a bintree is read as it was written") {
  convert::Bintree bintree = convert::blocks(read::read_csg_text("sphere($fn=20,$fa=12,$fs=2,r=3.3);", "m.csg"), 32);
  const convert::Bintree again = convert::read_bintree(convert::text_of(bintree), "b.bintree");
  CHECK(again.code == bintree.code);
  CHECK(again.resolution == 32);
  CHECK(again.low == bintree.low);
  CHECK(again.side == bintree.side);
}

TEST_CASE("what is no bintree is told") {
  const auto told = [](const std::string& text) {
    return testing::error_of([&] { convert::read_bintree(text, "b.bintree"); });
  };
  const std::string head = "bintree 1\nresolution 2\ncube 0 0 0 1\n";
  CHECK(told(head + "(((01(01((0101").find("b.bintree: the code is not that of one whole tree") == 0);
  CHECK(told(head + "(((01(01((01(01") == "");
  CHECK(told(head + "(((01(01((01(01" + "1") != "");
  CHECK(told(head + "((((0001(01((01(01") != "");  // a cell that is halved
  CHECK(told(head + "2") != "");
  CHECK(told("bintree 1\nresolution 3\ncube 0 0 0 1\n0").find("power of two") != std::string::npos);
  CHECK(told("solid").find("'bintree' is missing") != std::string::npos);
  for (const char* const cube : {"nan 0 0 1", "0 inf 0 1", "0 0 0 inf", "0 0 0 0", "0 0 0 -1"}) {
    CAPTURE(cube);
    CHECK(told("bintree 1\nresolution 2\ncube " + std::string(cube) + "\n0").find("no place or no size") !=
          std::string::npos);
  }
  CHECK(told("bintree 1\nresolution 2\ncube 0 0 x 1\n0").find("'x' is no number") != std::string::npos);
}
