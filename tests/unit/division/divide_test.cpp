#include "hw/division/divide.h"

#include "hw/division/groups.h"
#include "hw/isa/opcodes.h"
#include "tests/support/test.h"
#include "tests/unit/division/hand_models.h"

using namespace csgsim;
using namespace isa;

namespace {

constexpr isa::Field z2{0, 4};
constexpr isa::Field z1{4, 4};
constexpr isa::Field colour{8, 3};
constexpr isa::Field mask{11, 1};

Instruction plain(Opcode opcode, isa::Field first, isa::Field second, std::uint64_t constant, isa::Origin origin) {
  return {opcode, {first, second, {}}, {}, constant, origin};
}

Instruction linear(Opcode opcode, isa::Field field, isa::Linear expression, isa::Origin origin) {
  return {opcode, {field, {}, {}}, expression, 0, origin};
}

constexpr isa::Origin setup{Purpose::setup, isa::no_primitive, isa::no_node};
constexpr isa::Origin render{Purpose::render, 0, isa::no_node};
constexpr isa::Origin merge{Purpose::merge, 0, isa::no_node};
constexpr isa::Origin shade{Purpose::shade, 0, isa::no_node};

constexpr isa::Region top_left{0, 0, 8, 8};

}  // namespace

TEST_CASE("a slab that fills a square is drawn by ten instructions") {
  testing::ModelDivider divider(testing::one_slab());
  const division::SquareDivision divided = divider.divide(top_left);
  const std::vector<Instruction> expected{
      plain(Opcode::enable_all, {}, {}, 0, setup),
      plain(Opcode::set_constant, z2, {}, 15, setup),
      plain(Opcode::set_constant, colour, {}, 6, setup),
      plain(Opcode::enable_all, {}, {}, 0, render),
      linear(Opcode::load_linear, z1, {0, 0, 3, 5, 0}, render),
      linear(Opcode::linear_gt, z1, {0, 0, 9, 5, 0}, render),
      plain(Opcode::field_lt, z1, z2, 0, merge),
      plain(Opcode::enable_store, mask, {}, 0, merge),
      plain(Opcode::copy, z2, z1, 0, merge),
      plain(Opcode::set_constant, colour, {}, 5, shade),
  };
  CHECK(divided.instructions == expected);
  // One list of two half-spaces; the front and the back take one cell each.
  CHECK(divided.steps == std::vector<division::Counts>{{1, 1, 2, 2, 0, 10}});
}

TEST_CASE("an empty square takes only a box test per primitive") {
  const division::SquareDivision divided = testing::ModelDivider(testing::one_slab()).divide({8, 0, 8, 8});
  CHECK(divided.instructions.empty());
  CHECK(divided.steps == std::vector<division::Counts>{{.boxes = 1}});
}

TEST_CASE("a square as large as the picture is initialized even if it is empty") {
  CHECK(testing::ModelDivider(testing::empty_model()).divide({0, 0, 16, 16}).instructions.size() == 3);
}

TEST_CASE("a square's linear expressions are relative to its corner") {
  division::DisplayModel model = testing::one_slab();
  model.planes[0] = {false, 0, 0, 3};
  model.primitives[0].box.pixels = {10, 0, 15, 15};
  const division::SquareDivision divided = testing::ModelDivider(model).divide({8, 8, 8, 8});
  // x - 10 in columns 8 to 15 is -2 to 5, which needs 4 bits.
  CHECK(divided.instructions[4] == linear(Opcode::edge_not_negative, {}, {1, 0, -2, 4, 0}, render));
}

TEST_CASE("the divider draws a surface without a front from depth 0 in its near colour") {
  division::DisplayModel model = testing::one_slab();
  model.planes[0].c = 0;
  for (const std::int64_t z_low : {0, 2}) {
    model.primitives[0].box.z_low = z_low;
    const std::vector<Instruction> made = testing::ModelDivider(model).divide(top_left).instructions;
    CHECK(made.size() == 10);
    CHECK(made.at(4) == plain(Opcode::set_constant, z1, {}, 0, render));
    CHECK(made.back() == plain(Opcode::set_constant, colour, {}, 1, shade));
  }
}

TEST_CASE("the divider draws and compares a hole only in squares that contain it") {
  testing::ModelDivider divider(testing::slab_with_hole());
  const division::SquareDivision holed = divider.divide(top_left);
  // The slab and the hole, each with its own two half-spaces and two of the other; each tests the root and the
  // other.
  CHECK(holed.counts().boxes == 2);
  CHECK(holed.counts().halfspaces == 8);
  CHECK(holed.counts().nodes == 4);
  // The hole has no pixels in columns 6 and 7: the slab tests the root and, without effect, the hole.
  const division::SquareDivision whole = divider.divide({6, 0, 2, 8});
  CHECK(whole.counts().boxes == 2);
  CHECK(whole.counts().halfspaces == 2);
  CHECK(whole.counts().nodes == 2);
  CHECK(whole.instructions.size() == 10);
}

TEST_CASE("the divider rejects a tree with more pending results than stack bits") {
  division::DisplayModel model = testing::slab_with_hole();
  // The slab minus the intersection of two holes: a union of complements is a single leaf, unless a plain solid is part
  // of it.
  model.primitives.push_back(testing::slab(0, 3, 3, 5));
  model.primitives[2].box.pixels = {3, 0, 6, 15};
  model.nodes = {{}, {}, {}, {2, division::Operator::unite}, {2, division::Operator::intersect}};
  CHECK_FALSE(testing::ModelDivider(model).divide(top_left).instructions.empty());
  model.fields.stack_bits = 0;
  CHECK_THROWS_WITH_AS(
      static_cast<void>(testing::ModelDivider(model).divide(top_left)),
      "a square's tree needs 1 bits for intermediate results, but pixel memory has 0; increase array.memory_bits",
      InputError);
}

TEST_CASE("a group of squares keeps the primitives in it and their deciding half-spaces") {
  division::DisplayModel model = testing::slab_with_hole();
  // A second front that is always nearer than the slab's, and an edge that contains the left half.
  model.planes.push_back({false, 0, 0, 1});
  model.planes.push_back({true, -1, 0, 7});
  model.primitives[0].halfspaces.push_back({4, true, 2});
  model.primitives[0].halfspaces.push_back({5, true, 0});
  division::validate(model);
  testing::ModelDivider divider(model);
  const division::Candidates left = divider.survivors({0, 0, 16, 8});
  // The two fronts of the slab are compared with their leader; then come its back and the hole's front and back.
  CHECK(divider.path.take_counts() == division::Counts{2, 2, 6, 5, 0, 0});
  CHECK(left.primitives == std::vector<std::uint32_t>{0, 1});
  CHECK(left.halfspaces[0].size() == 2);
  CHECK(left.entry_count() == 6);
  const division::SquareDivision from_group = divider.divide(top_left, left);
  const division::SquareDivision from_model = divider.divide(top_left);
  CHECK(from_group.instructions == from_model.instructions);
  CHECK(from_group.counts().halfspaces == 8);
  CHECK(from_model.counts().halfspaces == 12);
}

TEST_CASE("squares in rows form groups that are clipped at the picture's edges") {
  // 5 x 3 squares of 8 x 8 in a picture of 37 x 24, in groups of 2 x 2.
  std::vector<isa::Region> squares;
  for (std::uint32_t y = 0; y < 24; y += 8) {
    for (std::uint32_t x = 0; x < 37; x += 8) squares.push_back({x, y, std::min(8U, 37 - x), 8});
  }
  const std::vector<division::Group> groups = division::group_squares(squares, {37, 24, 0}, {8, 8, 0}, 2, 2);
  REQUIRE(groups.size() == 6);
  CHECK(groups[0].region == isa::Region{0, 0, 16, 16});
  CHECK(groups[0].squares == std::vector<std::size_t>{0, 1, 5, 6});
  CHECK(groups[2].region == isa::Region{32, 0, 5, 16});
  CHECK(groups[2].squares == std::vector<std::size_t>{4, 9});
  CHECK(groups[5].region == isa::Region{32, 16, 5, 8});
  CHECK(groups[5].squares == std::vector<std::size_t>{14});
}

TEST_CASE("a group with too many remaining half-spaces is divided from the whole model") {
  testing::ModelDivider divider(testing::slab_with_hole());
  const division::DividedGroup fits = divider.divide_group({0, 0, 16, 16}, {top_left}, 6);
  CHECK(fits.fits);
  const division::DividedGroup full = divider.divide_group({8, 0, 8, 16}, {{8, 0, 8, 8}}, 5);
  CHECK(full.fits);
  CHECK(full.entries == 0);
  CHECK(full.squares[0].counts().boxes == 0);
  const division::DividedGroup spills = divider.divide_group({0, 0, 16, 16}, {{8, 0, 8, 8}}, 5);
  CHECK_FALSE(spills.fits);
  CHECK(spills.squares[0].counts().boxes == 2);
}
