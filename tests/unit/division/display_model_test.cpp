#include "hw/division/display_model.h"

#include "host/emit/display_model.h"
#include "hw/division/encoding.h"
#include "tests/support/test.h"
#include "tests/unit/division/agreement.h"

using namespace csgsim;

namespace {

testing::Setup along_y(const view::Sampling& sampling = {64, 48, 20, 12, 1.0 / 256, std::nullopt}) {
  return testing::squares_of({{0.03, -60, 0}, {0, 0, 0}, view::Projection::orthographic}, sampling, {16, 16},
                             emit::Colouring::rebroadcast);
}

division::DisplayModel sent_for(const std::string& text, const testing::Setup& setup) {
  return division::decode(testing::compile_for_divider(text, setup).sent);
}

/// A cube with its right face at the given number of pixels right of the picture's centre.
std::string cube_to(double pixels, const testing::Setup& setup) {
  const double half = pixels * view::pixel_size(setup.camera, setup.sampling.height, 0);
  return fmt::format("cube(size=[{0},{0},{0}],center=true);", 2 * half);
}

}  // namespace

TEST_CASE("a plane of several half-spaces is sent once in the display model") {
  const std::string beside = "multmatrix([[1,0,0,4],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(size=4);}";
  const division::DisplayModel model = sent_for("union(){cube(size=4);" + beside + "}", along_y());
  CHECK(model.primitives.size() == 2);
  // Four common sides, and x = 0, 4 and 8.
  CHECK(model.planes.size() == 7);
  CHECK(model.primitives[0].halfspaces.size() + model.primitives[1].halfspaces.size() == 12);
}

TEST_CASE("the display model has a primitive outside the picture without half-spaces") {
  const std::string away = "multmatrix([[1,0,0,400],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(size=4);}";
  const division::DisplayModel model = sent_for("union(){cube(size=4);" + away + "}", along_y());
  CHECK(model.primitives[1].box.pixels.empty());
  CHECK(model.primitives[1].halfspaces.empty());
}

TEST_CASE("the display model marks primitives that are joined only by intersections") {
  const division::DisplayModel model =
      sent_for("difference(){intersection(){cube(size=4);cube(size=3);}cube(size=1);}", along_y());
  REQUIRE(model.primitives.size() == 3);
  CHECK_FALSE(model.primitives[0].joined);
  CHECK(model.primitives[1].joined);
  CHECK_FALSE(model.primitives[2].joined);
  CHECK(model.primitives[2].complemented);
}

TEST_CASE("the stack of a divided picture gets all memory that the other fields leave") {
  testing::Setup setup = along_y();
  CHECK(sent_for("cube(size=4);", setup).fields.stack_base == 2 * 20 + 24 + 1);
  CHECK(sent_for("cube(size=4);", setup).fields.stack_bits == setup.memory_bits - 65);
  setup.options.colouring = emit::Colouring::field;
  CHECK(sent_for("cube(size=4);", setup).fields.stack_base == 2 * 20 + 2 * 24 + 1);
}

TEST_CASE("a display model is rejected with too little memory or automatic colouring") {
  const testing::Compiled any = testing::compile_text("cube(size=4);", along_y());
  emit::Options options;
  CHECK_THROWS_AS(emit::make_display_model(any.tree, any.scene, any.view, options, 64), InputError);
  CHECK_NOTHROW(emit::make_display_model(any.tree, any.scene, any.view, options, 65));
  options.colouring = emit::Colouring::automatic;
  CHECK_THROWS_AS(emit::make_display_model(any.tree, any.scene, any.view, options, 72), InputError);
}

TEST_CASE("the display model omits a face that fits no width if all its pixels are inside") {
  // The side faces cross the depth range within a hundredth of a pixel.
  const testing::Setup setup = along_y({64, 48, 30, 20, 1.0 / 4096, std::nullopt});
  testing::DivisionCase how;
  how.setup = setup;
  const testing::ForDivider between = testing::compile_for_divider(cube_to(10.0, setup), setup);
  const auto& planes = between.host.view.planes;
  REQUIRE(std::any_of(planes.begin(), planes.end(), [](const auto& plane) { return !plane.representable; }));
  const division::DisplayModel model = division::decode(between.sent);
  CHECK(model.primitives[0].halfspaces.size() < 6);
  division::Counts done;
  CHECK(testing::difference(between, how, done) == "");
  // Half a pixel less, and the face passes through pixel centres.
  CHECK_THROWS_AS(testing::compile_for_divider(cube_to(9.5, setup), setup), InputError);
}
