#include "sim/software/convert/blocks.h"

#include <rapidcheck.h>

#include "host/facet/solid.h"
#include "host/model/tree.h"
#include "host/read/read.h"
#include "hw/base/work.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/split_mix.h"
#include "tests/oracle/tree_rules.h"
#include "tests/support/test.h"
#include "tests/unit/convert/random_blocks.h"

using namespace csgsim;
namespace convert = software::convert;
using testing::Random;

namespace {

/// Solids of a tree; a point on a face counts as shifted slightly along x, then y, then z.
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

/// First cell that differs from the state of its centre; empty if none does.
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

TEST_CASE("each cell of a block model has the state of its centre in maximal blocks") {
  int full = 0;
  CHECK(rc::check([&](std::uint64_t seed) {
    Random random(seed);
    const auto count = 2 + static_cast<unsigned>(random.below(8));
    const model::Tree tree = random.below(2) == 0 ? testing::random_boxes(random, count).tree
                                                  : read::read_csg_text(testing::random_model(seed, count), "m.csg");
    const std::uint32_t resolution = random.one_of({2U, 4U, 8U, 16U});
    const convert::Bintree bintree = convert::blocks(tree, resolution);
    if (tree.root != model::no_index) RC_ASSERT(wrong_cell(tree, bintree) == "");
    // Encoding the individual cells merges all uniform blocks.
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

TEST_CASE("a cube is coded as one block and its lower half along x as two") {
  CHECK(convert::blocks(read::read_csg_text("cube([4,4,4]);", "m.csg"), 4).code == "1");
  const std::string half =
      "difference(){cube([4,4,4]);multmatrix([[1,0,0,2],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){"
      "cube([4,4,4]);}}cube([0.1,0.1,0.1]);"
      "multmatrix([[1,0,0,3.9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube([0.1,0.1,0.1]);}";
  CHECK(convert::blocks(read::read_csg_text(half, "m.csg"), 2).code == "(10");
}

TEST_CASE("a bintree survives writing and reading") {
  convert::Bintree bintree = convert::blocks(read::read_csg_text("sphere($fn=20,$fa=12,$fs=2,r=3.3);", "m.csg"), 32);
  const convert::Bintree again = convert::read_bintree(convert::text_of(bintree), "b.bintree");
  CHECK(again.code == bintree.code);
  CHECK(again.resolution == 32);
  CHECK(again.low == bintree.low);
  CHECK(again.side == bintree.side);
}

TEST_CASE("rejects malformed bintrees") {
  const auto refusal = [](const std::string& text) {
    return testing::error_of([&] { convert::read_bintree(text, "b.bintree"); });
  };
  const std::string head = "bintree 1\nresolution 2\ncube 0 0 0 1\n";
  CHECK(refusal(head + "(((01(01((0101").find("b.bintree: the code is not one complete tree") == 0);
  CHECK(refusal(head + "(((01(01((01(01") == "");
  CHECK(refusal(head + "(((01(01((01(01" + "1") != "");
  CHECK(refusal(head + "((((0001(01((01(01") != "");  // a cell is subdivided
  CHECK(refusal(head + "2") != "");
  CHECK(refusal("bintree 1\nresolution 3\ncube 0 0 0 1\n0").find("power of two") != std::string::npos);
  CHECK(refusal("solid").find("'bintree' is missing") != std::string::npos);
  for (const char* const cube : {"nan 0 0 1", "0 inf 0 1", "0 0 0 inf", "0 0 0 0", "0 0 0 -1"}) {
    CAPTURE(cube);
    CHECK(refusal("bintree 1\nresolution 2\ncube " + std::string(cube) + "\n0")
              .find("the cube needs a finite position and a finite side above 0") != std::string::npos);
  }
  CHECK(refusal("bintree 1\nresolution 2\ncube 0 0 x 1\n0").find("'x' is not a number") != std::string::npos);
}

TEST_CASE("a 4 x 4 x 2 block has the hand-calculated bintree code") {
  // A 4 x 4 x 2 block in a cube of 4 with its low corner at (0, 0, -1) fills the middle two of four layers along z.
  // Halving across x, y and z yields eight cubes of 2, the lower ones with their upper layer full, which are halved
  // down to cells.
  const std::string pair_low = "(01";
  const std::string pair_high = "(10";
  const auto cube_of = [](const std::string& pair) {
    const std::string half = "(" + pair + pair;  // across y, each half across z
    return "(" + half + half;                    // across x
  };
  const std::string column = "(" + cube_of(pair_low) + cube_of(pair_high);
  const std::string code = "((" + column + column + "(" + column + column;
  const convert::Bintree bintree = convert::blocks(read::read_csg_text("cube([4,4,2]);", "m.csg"), 4);
  CHECK(bintree.code == code);
  CHECK(bintree.low == glm::dvec3(0, 0, -1));
  CHECK(bintree.side == 4);
  CHECK(bintree.cell() == 1);
  const convert::BlockCounts counts = convert::count_blocks(bintree);
  CHECK(counts.blocks == 64);
  CHECK(counts.full == 32);
  CHECK(counts.cells == 32);
  const convert::BlockCounts whole = convert::count_blocks({.resolution = 8, .code = "(01"});
  CHECK(whole.blocks == 2);
  CHECK(whole.full == 1);
  CHECK(whole.cells == 8 * 8 * 8 / 2);
  for (const auto& [csg, low] : {std::pair<const char*, glm::dvec3>{"cube([2,6,4]);", {-2, 0, -1}},
                                 {"cube([2,4,6]);", {-2, -1, 0}},
                                 {"cube([6,4,2]);", {0, -1, -2}}}) {
    const convert::Bintree other = convert::blocks(read::read_csg_text(csg, "m.csg"), 2);
    CHECK(other.side == 6);
    CHECK(other.low == low);
    CHECK(other.cell() == 3);
  }
  const convert::Bintree nothing = convert::blocks(model::Tree{}, 8);
  CHECK(nothing.code == "0");
  CHECK(nothing.resolution == 8);
  CHECK(nothing.side == 1);
}

TEST_CASE("a bintree subdivides across the three axes in turn") {
  // The cell at (x, y, z) of a cube of 2, with an empty half before or after it across x, then y, then z.
  for (int x = 0; x < 2; ++x) {
    for (int y = 0; y < 2; ++y) {
      for (int z = 0; z < 2; ++z) {
        std::vector<bool> cells(8, false);
        cells[static_cast<std::size_t>((z * 2 + y) * 2 + x)] = true;
        const auto halves = [](int which, const std::string& in) { return which == 0 ? "(" + in + "0" : "(0" + in; };
        const std::string code = halves(x, halves(y, halves(z, "1")));
        CHECK(convert::code_of(cells, 2) == code);
        CHECK(convert::cells_of({.resolution = 2, .code = code}) == cells);
      }
    }
  }
}

TEST_CASE("the code of a bintree is written in lines of at most 120 characters") {
  convert::Bintree bintree{.resolution = 4, .low = {1, -2.5, 0}, .side = 0.1, .code = std::string(120, '0')};
  CHECK(convert::text_of(bintree) == "bintree 1\nresolution 4\ncube 1 -2.5 0 0.1\n" + std::string(120, '0') + "\n");
  bintree.code += "(";
  CHECK(convert::text_of(bintree) == "bintree 1\nresolution 4\ncube 1 -2.5 0 0.1\n" + std::string(120, '0') + "\n(\n");
}

TEST_CASE("rejects a bintree without a keyword or with an invalid resolution") {
  const auto refusal = [](const std::string& text) {
    return testing::error_of([&] { convert::read_bintree(text, "b.bintree"); });
  };
  const auto of_resolution = [](const std::string& resolution) {
    return "bintree 1\nresolution " + resolution + "\ncube 0 0 0 1\n0";
  };
  for (const char* const resolution : {"2", "4", "1024"}) CHECK(refusal(of_resolution(resolution)) == "");
  for (const char* const resolution : {"0", "1", "3", "6", "1023", "2048"})
    CHECK(refusal(of_resolution(resolution)) ==
          "b.bintree: the resolution is not a power of two from 2 to 1024; create the bintree again");
  CHECK(refusal(of_resolution("4x")) == "b.bintree: '4x' is not a number; create the bintree again");
  CHECK(refusal(of_resolution("-4")) == "b.bintree: '-4' is not a number; create the bintree again");
  CHECK(refusal("bintree 2\nresolution 2\ncube 0 0 0 1\n0") == "b.bintree: '1' is missing; create the bintree again");
  CHECK(refusal("bintree 1\nsize 2\ncube 0 0 0 1\n0") ==
        "b.bintree: 'resolution' is missing; create the bintree again");
  CHECK(refusal("bintree 1\nresolution 2\nbox 0 0 0 1\n0") == "b.bintree: 'cube' is missing; create the bintree again");
  CHECK(refusal("bintree 1\nresolution 2\ncube 0 0 0") == "b.bintree: '' is not a number; create the bintree again");
  CHECK(refusal("bintree 1\nresolution 2\ncube 0 0 0 1\n").find("the code is not one complete tree") !=
        std::string::npos);
  CHECK(refusal("bintree 1\nresolution 2\ncube 0 -inf 0 1\n0")
            .find("the cube needs a finite position and a finite side above 0") != std::string::npos);
  CHECK(refusal("bintree 1\nresolution 2\ncube 0 0 inf 1\n0")
            .find("the cube needs a finite position and a finite side above 0") != std::string::npos);
  // Any whitespace is accepted, also within the code.
  const convert::Bintree read = convert::read_bintree("\tbintree 1 resolution 2\r\ncube 1 2 3 1e-3 ( 0\n1", "b");
  CHECK(read.code == "(01");
  CHECK(read.low == glm::dvec3(1, 2, 3));
  CHECK(read.side == 1e-3);
}

TEST_CASE("a centre on a plane counts as belonging to the higher side") {
  // Cells of 2 in a cube of 4 have their centres at 1 and 3: for a box from 1 to 3 the first is in and the second is
  // out. Cubes of a tenth in two corners, which contain no centre, extend the model to that size.
  const std::string model =
      "cube([0.1,0.1,0.1]);multmatrix([[1,0,0,3.9],[0,1,0,3.9],[0,0,1,3.9],[0,0,0,1]]){cube([0.1,0.1,0.1]);}"
      "multmatrix([[1,0,0,1],[0,1,0,1],[0,0,1,1],[0,0,0,1]]){cube([2,2,2]);}";
  const std::vector<bool> cells = convert::cells_of(convert::blocks(read::read_csg_text(model, "m.csg"), 2));
  for (std::size_t i = 0; i < 8; ++i) CHECK(cells[i] == (i == 0));
}

TEST_CASE("converting to blocks counts work for each face of a body and ray of its rows") {
  const auto work_of = [](const std::string& csg, std::uint32_t resolution) {
    const Work work(1'000'000'000);
    convert::blocks(read::read_csg_text(csg, "m.csg"), resolution, {}, work);
    return work.done();
  };
  CHECK(work_of("cube([4,4,4]);", 8) - work_of("cube([4,4,4]);", 2) == 6 * (8 * 8 - 2 * 2));
  // The box spans half of the rows.
  CHECK(work_of("cube([4,2,4]);", 16) - work_of("cube([4,2,4]);", 4) == 6 * (8 * 16 - 2 * 4));
  const Work little(100);
  CHECK(testing::error_of([&] {
          convert::blocks(read::read_csg_text("cube([4,4,4]);", "m.csg"), 1024, {}, little);
        }).find("converting the model to blocks needs more work") == 0);
}