#include <glm/common.hpp>

#include "host/read/read.h"
#include "hw/isa/colour_format.h"
#include "hw/scan_line/kind.h"
#include "sim/observe/frame.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;
using testing::box_text;

namespace {

const std::string shadows = "[effects.shadows]\n";

/// The light shines to the right and away from the eye.
const std::string slanted = "[[lights]]\ndirection = [1, 1, 0]\n";

std::string lamp(const glm::dvec3& place, const glm::dvec3& colour) {
  return fmt::format("[[lights]]\nkind = \"point\"\nposition = [{}, {}, {}]\ncolour = [{}, {}, {}]\n", place.x, place.y,
                     place.z, colour.x, colour.y, colour.z);
}

struct Tally {
  int pixels = 0;
  int judged = 0;
  int dark = 0;  ///< number of judged pixels that shadows change
  int wrong = 0;

  Tally& operator+=(const Tally& other) {
    pixels += other.pixels;
    judged += other.judged;
    dark += other.dark;
    wrong += other.wrong;
    return *this;
  }
};

/// The depths of the visible surface and of a plane are both truncated to whole steps and both have rounded
/// coefficients; a difference above this value is certain.
constexpr double steps_in_doubt = 1.25;

/// Compares a picture with shadows against rays.
Tally judge(const std::string& csg, const testing::Setup& setup) {
  const testing::Compiled compiled = testing::compile_text(csg, setup);
  const observe::Frame frame = testing::draw(compiled.program);
  testing::RayShot shot;
  shot.camera = setup.camera;
  shot.width = setup.sampling.width;
  shot.height = setup.sampling.height;
  if (setup.camera.projection == view::Projection::perspective) shot.near = compiled.view.depth.near;
  const testing::RayDoubt doubt{0.01, steps_in_doubt * compiled.view.depth_step};
  testing::RayEffects effects;
  const auto plain = testing::ray_picture(compiled.tree, compiled.scene, setup.options.scene, shot, effects, doubt);
  effects.has_shadows = true;
  const auto cast = testing::ray_picture(compiled.tree, compiled.scene, setup.options.scene, shot, effects, doubt);
  Tally tally;
  for (std::size_t i = 0; i < cast.size(); ++i) {
    ++tally.pixels;
    if (!cast[i].is_certain) continue;
    ++tally.judged;
    tally.dark += plain[i].colour != cast[i].colour ? 1 : 0;
    if (testing::colour_error(frame.colour[i], cast[i].colour) <= 0.5 + 1e-6) continue;
    ++tally.wrong;
    MESSAGE("column ", i % setup.sampling.width, " row ", i / setup.sampling.width, " off by ",
            testing::colour_error(frame.colour[i], cast[i].colour), " of primitive ", cast[i].primitive,
            ", in the light ", testing::colour_error(frame.colour[i], plain[i].colour));
  }
  return tally;
}

testing::Setup seen_from(const std::string& csg, const glm::dvec3& from, view::Projection projection,
                         const scene::Scene& scene) {
  constexpr std::uint32_t width = 64;
  constexpr std::uint32_t height = 48;
  testing::Setup setup = testing::front_view(width, height, scene);
  const facet::Box box = facet::make_geometry(read::read_csg_text(csg, "model")).box;
  if (!box.empty()) setup.camera = view::view_all({from, {0, 0, 0}, projection}, box, width, height);
  return setup;
}

/// A random model above a floor; empty text if the model is empty.
std::string on_a_floor(std::uint64_t seed) {
  const std::string csg = testing::random_model(seed, 2 + static_cast<unsigned>(seed % 11));
  const facet::Box box = facet::make_geometry(read::read_csg_text(csg, "random")).box;
  if (box.empty()) return "";
  const glm::dvec3 more = 0.4 * (box.high - box.low);
  return "union(){" + csg +
         box_text({box.low.x - more.x, box.low.y - more.y, box.low.z - 1.3},
                  {box.high.x + more.x, box.high.y + more.y, box.low.z - 0.3}) +
         "}";
}

Tally check_random(std::uint64_t first_seed, view::Projection projection, const std::string& lights,
                   unsigned z_bits = 20) {
  const auto models = testing::cases<std::uint64_t>(25, 8);
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + models; ++seed) {
    CAPTURE(seed);
    const std::string csg = on_a_floor(seed);
    if (csg.empty()) continue;
    const double turn = 0.7 * static_cast<double>(seed);
    testing::Setup setup =
        seen_from(csg, {std::cos(turn), std::sin(turn), 0.63}, projection, testing::scene_of(shadows + lights));
    setup.sampling.z_bits = z_bits;
    tally += judge(csg, setup);
  }
  return tally;
}

void check(const Tally& tally) {
  MESSAGE(tally.pixels, " pixels, ", tally.judged, " judged, ", tally.dark, " in shadow, ", tally.wrong, " wrong");
  CHECK(tally.wrong == 0);
  CHECK(tally.judged > tally.pixels * 3 / 4);
  CHECK(tally.dark > tally.pixels / 100);
}

/// Columns and rows are in model units.
testing::Setup wall_view(const std::string& toml) { return testing::front_view(24, 24, testing::scene_of(toml)); }

const std::string wall = box_text({0, 5, -24}, {24, 6, 0});

std::uint32_t colour_at(const observe::Frame& frame, std::uint32_t x, std::uint32_t y) {
  return frame.colour[std::size_t{y} * frame.width + x];
}

observe::Frame drawn(const std::string& csg, const testing::Setup& setup) {
  return testing::draw(testing::compile_text(csg, setup).program);
}

}  // namespace

TEST_CASE("orthographic shadows of random models in the default light match rays") {
  check(check_random(1, view::Projection::orthographic, ""));
}

TEST_CASE("perspective shadows of random models in light from above match rays") {
  check(check_random(101, view::Projection::perspective, "[[lights]]\ndirection = [0.3, 0.5, -1]\n"));
}

TEST_CASE("orthographic shadows of random models in two coloured lights match rays") {
  check(check_random(201, view::Projection::orthographic,
                     lamp({9, -7, 14}, {1, 0.5, 0.2}) +
                         "[[lights]]\ndirection = [-1, 0.2, -0.7]\ncolour = [0.2, 0.4, 1]\nintensity = 0.5\n"));
}

TEST_CASE("perspective shadows of random models with lamps among solids match rays") {
  check(check_random(
      301, view::Projection::perspective,
      lamp({0.3, 0.2, 0.7}, {1, 1, 1}) + lamp({2.3, -4.2, 3.7}, {1, 0, 0}) + lamp({-5.3, 4.2, 6.7}, {0, 1, 0})));
}

TEST_CASE("shadow errors with few depth bits stay within the depth steps") {
  const std::string light = "[[lights]]\ndirection = [0.3, 0.5, -1]\n";
  for (const unsigned z_bits : {8U, 11U}) {
    const Tally tally = check_random(401, view::Projection::orthographic, light, z_bits);
    MESSAGE(z_bits, " bits: ", tally.judged, " of ", tally.pixels, " judged, ", tally.dark, " in shadow");
    CHECK(tally.wrong == 0);
    CHECK(tally.judged > tally.pixels / 2);
    CHECK(tally.dark > tally.pixels / 200);
  }
}

TEST_CASE("light passes through a hole but not through seams between convex pieces") {
  const std::string hole = "multmatrix([[1,0,0,10],[0,1,0,0],[0,0,1,-10],[0,0,0,1]]){sphere($fn=16,$fa=12,$fs=2,r=4);}";
  const std::string csg = "union(){" + wall + "difference(){" + box_text({2, 0, -18}, {18, 1, -2}) + hole + "}}";
  const testing::Setup setup = wall_view(shadows + "[[lights]]\ndirection = [0.31, 1, -0.17]\n");
  const Tally tally = judge(csg, setup);
  check(tally);
  CHECK(tally.judged > 500);
  // The wall to the right of the plate is dark up to 18 + 0.31 * 4, without a gap.
  const observe::Frame frame = drawn(csg, setup);
  const std::uint32_t dark = colour_at(frame, 18, 10);
  CHECK(dark != colour_at(frame, 22, 10));
  for (std::uint32_t y = 3; y < 18; ++y) {
    CAPTURE(y);
    CHECK(colour_at(frame, 18, y) == dark);
  }
}

TEST_CASE("light parallel to the seams of pieces does not leak through") {
  // The upper and lower sides of the hole, which cut the plate, are planes parallel to the light.
  const std::string csg = "union(){" + wall + "difference(){" + box_text({2, 0, -18}, {18, 1, -2}) +
                          box_text({7.5, -1, -12.5}, {12.5, 2, -7.5}) + "}}";
  const observe::Frame frame = drawn(csg, wall_view(shadows + slanted));
  const std::uint32_t dark = colour_at(frame, 20, 10);
  CHECK(dark != colour_at(frame, 0, 10));
  // The shadow of the plate's right end reaches from its back at 1 to the wall at 5.
  for (std::uint32_t x = 18; x < 22; ++x) {
    CAPTURE(x);
    for (std::uint32_t y = 2; y < 18; ++y) CHECK(colour_at(frame, x, y) == dark);
    CHECK(colour_at(frame, x, 1) != dark);
    CHECK(colour_at(frame, x, 18) != dark);
  }
  CHECK(colour_at(frame, 23, 10) != dark);
}

TEST_CASE("a convex solid casts no shadow on itself and needs no instructions for it") {
  const std::string ball = "sphere($fn=24,$fa=12,$fs=2,r=8);";
  for (const std::string light : {"[[lights]]\ndirection = [1, 1, -0.4]\n", "[[lights]]\ndirection = [1, -0.1, 0]\n"}) {
    for (const auto projection : {view::Projection::orthographic, view::Projection::perspective}) {
      const testing::Setup setup = seen_from(ball, {1, 2, 3}, projection, testing::scene_of(shadows + light));
      testing::Setup without = setup;
      without.options.scene = testing::scene_of(light);
      const testing::Compiled shadowed = testing::compile_text(ball, setup);
      CHECK(testing::draw(shadowed.program).colour == drawn(ball, without).colour);
      for (const isa::Instruction& one : shadowed.program.segments.front().instructions)
        CHECK(one.origin.purpose != isa::Purpose::effect);
    }
  }
}

TEST_CASE("subtracted and empty solids cast no shadow") {
  const std::string block = box_text({4, 0, -14}, {12, 2, -6});
  const testing::Setup setup = wall_view(shadows + slanted);
  const observe::Frame expected = drawn(wall, setup);
  CHECK(drawn("union(){" + wall + "difference(){" + block + block + "}}", setup).colour == expected.colour);
  CHECK(drawn("union(){" + wall + block + "}", setup).colour != expected.colour);
}

TEST_CASE("solids that share a face cast the shadow of their union") {
  const std::string whole = box_text({4, 0, -14}, {12, 2, -6});
  const std::string halves = box_text({4, 0, -14}, {8, 2, -6}) + box_text({8, 0, -14}, {12, 2, -6});
  const testing::Setup setup = wall_view(shadows + slanted);
  CHECK(drawn("union(){" + wall + whole + "}", setup).colour == drawn("union(){" + wall + halves + "}", setup).colour);
}

TEST_CASE("light along a shared face does not leak through with few depth bits") {
  const std::string floor = box_text({-20, -20, -2}, {20, 20, -1});
  const std::string whole = "union(){" + floor + box_text({-4, -3, 2}, {6, 3, 5}) + "}";
  const std::string halves =
      "union(){" + floor + box_text({-4, -3, 2}, {1, 3, 5}) + box_text({1, -3, 2}, {6, 3, 5}) + "}";
  const std::string light = "[[lights]]\ndirection = [0, 1, -1]\n";
  for (const unsigned z_bits : {6U, 9U, 20U}) {
    for (const double turn : {2.0, 1.1, 0.3, 2.8}) {
      CAPTURE(z_bits);
      CAPTURE(turn);
      testing::Setup dark = seen_from(whole, {std::cos(turn), std::sin(turn), 0.8}, view::Projection::orthographic,
                                      testing::scene_of(shadows + light));
      dark.sampling.z_bits = z_bits;
      testing::Setup lit = dark;
      lit.options.scene = testing::scene_of(light);
      const std::array frames{drawn(whole, dark), drawn(halves, dark), drawn(whole, lit), drawn(halves, lit)};
      int wrong = 0;
      int in_shadow = 0;
      for (std::size_t i = 0; i < frames[0].colour.size(); ++i) {
        // Another facet may be visible at an edge with few depths, in any light.
        if (frames[2].colour[i] != frames[3].colour[i]) continue;
        wrong += frames[0].colour[i] != frames[1].colour[i];
        in_shadow += frames[0].colour[i] != frames[2].colour[i];
      }
      CHECK(wrong == 0);
      CHECK(in_shadow > 20);
    }
  }
}

TEST_CASE("a lamp in an open box lights its inside and a closed box blocks it") {
  const std::string block = box_text({2, 0, -20}, {20, 10, -2});
  const std::string open = "difference(){" + block + box_text({3, -1, -19}, {19, 9, -3}) + "}";
  const std::string closed = "difference(){" + block + box_text({3, 1, -19}, {19, 9, -3}) + "}";
  const std::string light = lamp({11.2, 2.1, -10.7}, {1, 1, 1});
  check(judge("union(){" + open + box_text({6, 4, -8}, {9, 6, -5}) + "}", wall_view(shadows + light)));
  // All visible faces of the closed box face away from the lamp, unlike the wall next to it.
  const testing::Setup dark = wall_view(shadows + lamp({11.2, 2.1, -10.7}, {0, 0, 0}));
  const std::string behind = box_text({0, 12, -24}, {24, 13, 0});
  CHECK(drawn("union(){" + closed + behind + "}", wall_view(shadows + light)).colour ==
        drawn("union(){" + closed + behind + "}", dark).colour);
  CHECK(drawn("union(){" + open + behind + "}", wall_view(shadows + light)).colour !=
        drawn("union(){" + open + behind + "}", dark).colour);
}

TEST_CASE("shadows are the same without pruning and on a scan-line machine and with lists") {
  const std::string lights = lamp({9, -7, 14}, {1, 0.5, 0.2}) + "[[lights]]\ndirection = [-1, 0.2, -0.7]\n";
  for (const std::uint64_t seed : {7U, 9U, 31U}) {
    CAPTURE(seed);
    const std::string csg = on_a_floor(seed);
    const testing::Setup setup =
        seen_from(csg, {1, -2, 1.5}, view::Projection::perspective, testing::scene_of(shadows + lights));
    const observe::Frame expected = drawn(csg, setup);
    testing::Setup other = setup;
    other.options.pruning = csg::Pruning::none();
    CHECK(drawn(csg, other).colour == expected.colour);
    other = setup;
    other.kind = &scan_line::kind;
    CHECK(testing::compile_text(csg, other).program.segments.size() == 48);
    CHECK(drawn(csg, other).colour == expected.colour);
    other = setup;
    other.options.strategy = emit::Strategy::list;
    other.options.colouring = emit::Colouring::field;
    CHECK(drawn(csg, other).colour == expected.colour);
  }
}

TEST_CASE("shadows can be limited to one light or to some lines of the model") {
  const std::string lights = slanted + "[[lights]]\ndirection = [-1, 1, 0]\n";
  // box_text ends its line: the wall is on line 1 and the boxes are on lines 2 and 3.
  const std::string csg =
      "union(){" + wall + box_text({9, 0, -14}, {10, 1, -11}) + box_text({16, 0, -14}, {17, 1, -11}) + "}";
  // Columns in the row of the boxes where the wall is darker than in another row.
  const auto dark_columns = [&](const std::string& keys) {
    const observe::Frame frame = drawn(csg, wall_view(shadows + keys + lights));
    std::string columns;
    for (std::uint32_t x = 0; x < 24; ++x) {
      const bool is_box = x == 9 || x == 16;
      columns += is_box ? 'o' : colour_at(frame, x, 12) != colour_at(frame, x, 1) ? '#' : '.';
    }
    return columns;
  };
  // The boxes are 4 to 5 in front of the wall and 1 wide: the wall is dark 4 to 6 to the side of their start.
  CHECK(dark_columns("") == "....##...o.####.o...##..");
  CHECK(dark_columns("light = 0\n") == ".........o...##.o...##..");
  CHECK(dark_columns("light = 1\n") == "....##...o.##...o.......");
  CHECK(dark_columns("from_line = 2\n") == "....##...o...##.o.......");
  CHECK(dark_columns("from_line = 2\nto_line = 3\n") == "....##...o.####.o...##..");
  CHECK(dark_columns("from_line = 1\n") == ".........o......o.......");
}

TEST_CASE("a nonexistent light or an invalid range of lines for shadows is rejected") {
  CHECK(testing::error_of([] { drawn(wall, wall_view(shadows + "light = 2\n")); }).find("numbered 0 to 0") !=
        std::string::npos);
  CHECK(testing::error_of([] { testing::scene_of(shadows + "to_line = 2\n"); }).find("add from_line") !=
        std::string::npos);
  CHECK(testing::error_of([] {
          testing::scene_of(shadows + "from_line = 3\nto_line = 2\n");
        }).find("to_line precedes from_line") != std::string::npos);
}
