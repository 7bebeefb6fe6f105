#include <glm/common.hpp>

#include "host/effects/rows.h"
#include "host/lighting/lighting.h"
#include "host/read/read.h"
#include "hw/isa/colour_format.h"
#include "hw/pixel_square/kind.h"
#include "hw/scan_line/kind.h"
#include "tests/oracle/random_model.h"
#include "tests/oracle/ray_picture.h"
#include "tests/support/test.h"
#include "tests/unit/effects/effect_picture.h"

using namespace csgsim;
using testing::box_text;
using testing::front_view;
using testing::scene_of;
using testing::tinted;

namespace {

/// A mirroring floor and wall that reflect each other, with a sphere, a box and a box with a hole in front of them.
std::string room() {
  return "union(){" + tinted({0.5, 0.5, 0.6}, 1, box_text({-10, -10, -1}, {10, 10, 0})) +
         tinted({0.6, 0.5, 0.5}, 1, box_text({-10, 9, 0}, {10, 10, 12})) +
         tinted({0.9, 0.2, 0.1}, 1,
                "multmatrix([[1,0,0,-4],[0,1,0,2],[0,0,1,4.5],[0,0,0,1]])"
                "{sphere($fn=14,$fa=12,$fs=2,r=3);}") +
         tinted({0.2, 0.7, 0.3}, 1, box_text({2, -3, 1}, {6, 1, 5})) + "difference(){" +
         tinted({0.2, 0.3, 0.9}, 1, box_text({0, 4, 0}, {8, 6, 7})) +
         tinted({0.9, 0.9, 0.2}, 1, box_text({2, 3, 1}, {6, 7, 5})) + "}}";
}

const std::string lights = R"([ambient]
intensity = 0.35
[[lights]]
direction = [-1, 2, -2]
colour = [1, 0.9, 0.8]
intensity = 0.5
[[lights]]
kind = "point"
axes = "camera"
position = [-5, 9, 2]
intensity = 0.4
)";

const std::string mirroring = lights + R"([[materials]]
specular = 0.3
shininess = 9
[[materials]]
of_colour = [0.5, 0.5, 0.6]
mirror = 0.7
[[materials]]
of_colour = [0.6, 0.5, 0.5]
mirror = 0.4
[[materials]]
of_colour = [0.9, 0.9, 0.2]
mirror = 1
)";

testing::Setup view_of_room(std::uint32_t width, std::uint32_t height, view::Projection projection,
                            const scene::Scene& scene, const std::string& model) {
  testing::Setup setup = front_view(width, height, scene);
  const facet::Box box = facet::make_geometry(read::read_csg_text(model, "room")).box;
  setup.camera = view::view_all({{2.2, -3.1, 2}, {0, 0, 0}, projection}, box, width, height);
  setup.memory_bits = 1024;
  return setup;
}

/// All flat faces of mirroring materials according to the rules.
std::vector<testing::RayMirror> mirrors_of(const scene::Scene& scene, const testing::Compiled& compiled) {
  std::vector<testing::RayMirror> mirrors;
  for (std::uint32_t i = 0; i < compiled.tree.primitives.size(); ++i) {
    const model::Primitive& primitive = compiled.tree.primitives[i];
    const double reflectance = lighting::make_finish(scene, primitive, false).material.mirror;
    if (reflectance == 0 || std::holds_alternative<model::Sphere>(primitive.shape)) continue;
    const auto* const cylinder = std::get_if<model::Cylinder>(&primitive.shape);
    if (cylinder == nullptr) {
      mirrors.push_back({i, std::nullopt, reflectance});
      continue;
    }
    const auto last = static_cast<std::uint32_t>(compiled.scene.solids[i].halfspaces.size() - 1);
    if (cylinder->r1 > 0) mirrors.push_back({i, 0U, reflectance});
    if (cylinder->r2 > 0) mirrors.push_back({i, last, reflectance});
  }
  return mirrors;
}

struct Tally {
  int pixels = 0;
  int judged = 0;
  int mirrored = 0;  ///< number of judged pixels that mirrors change
  int wrong = 0;
};

/// Allows one level of error per mirror on the path, and half a level for rounding of the colours.
void judge(const std::string& model, const testing::Setup& setup, unsigned depth, Tally& tally) {
  const auto compiled = testing::compile_text(model, setup);
  const scene::Scene& scene = setup.options.scene;
  testing::RayEffects effects;
  effects.mirrors = mirrors_of(scene, compiled);
  effects.reflections = depth;
  const testing::RayShot shot{setup.camera, setup.sampling.width, setup.sampling.height};
  const auto expected = testing::ray_picture(compiled.tree, compiled.scene, scene, shot, effects);
  const auto without = testing::ray_picture(compiled.tree, compiled.scene, scene, shot);
  const observe::Frame frame = testing::draw(compiled.program);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ++tally.pixels;
    if (!expected[i].is_certain) continue;
    ++tally.judged;
    tally.mirrored += glm::length(expected[i].colour - without[i].colour) > 0.01 ? 1 : 0;
    const bool has_mirror = std::any_of(effects.mirrors.begin(), effects.mirrors.end(),
                                        [&](const auto& mirror) { return mirror.primitive == expected[i].primitive; });
    if (testing::colour_error(frame.colour[i], expected[i].colour) <= (has_mirror ? depth : 0) + 0.51) continue;
    ++tally.wrong;
    if (tally.wrong < 8)
      MESSAGE("column ", i % shot.width, " row ", i / shot.width, ": off by ",
              testing::colour_error(frame.colour[i], expected[i].colour));
  }
}

void check(const Tally& tally, int min_mirrored) {
  MESSAGE(tally.pixels, " pixels, ", tally.judged, " judged, ", tally.mirrored, " in mirrors, ", tally.wrong, " wrong");
  CHECK(tally.wrong == 0);
  CHECK(tally.judged > tally.pixels * 3 / 4);
  CHECK(tally.mirrored > min_mirrored);
}

scene::Scene to_depth(unsigned depth) { return scene_of(mirroring, {fmt::format("effects.mirrors.depth={}", depth)}); }

/// Every other line of the file mirrors.
scene::Scene by_line() {
  scene::Scene scene = scene_of(lights, {"effects.mirrors.depth=1"});
  for (std::uint32_t line = 1; line < 80; ++line) {
    scene::MaterialRule rule;
    rule.from_line = line;
    rule.to_line = line;
    rule.material.mirror = line % 3 == 0 ? 0.6 : 0;
    scene.materials.push_back(rule);
  }
  return scene;
}

Tally random_models(std::uint64_t first_seed, view::Projection projection) {
  Tally tally;
  for (std::uint64_t seed = first_seed; seed < first_seed + 25; ++seed) {
    CAPTURE(seed);
    const std::string model = testing::random_model(seed, 2 + static_cast<unsigned>(seed % 7));
    if (facet::make_geometry(read::read_csg_text(model, "random")).box.empty()) continue;
    judge(model, view_of_room(48, 40, projection, by_line(), model), 1, tally);
  }
  return tally;
}

bool same(const observe::Frame& a, const observe::Frame& b) { return a.colour == b.colour && a.depth == b.depth; }

observe::Frame drawn(const std::string& model, const testing::Setup& setup) {
  return testing::draw(testing::compile_text(model, setup).program);
}

}  // namespace

TEST_CASE("mirrors in a room match rays at each depth of reflection") {
  for (const unsigned depth : {1U, 2U, 3U}) {
    CAPTURE(depth);
    Tally tally;
    judge(room(), view_of_room(64, 56, view::Projection::orthographic, to_depth(depth), room()), depth, tally);
    judge(room(), view_of_room(64, 56, view::Projection::perspective, to_depth(depth), room()), depth, tally);
    check(tally, 1000);
  }
}

TEST_CASE("mirrors in random models match rays in orthographic views") {
  check(random_models(1, view::Projection::orthographic), 1000);
}
TEST_CASE("mirrors in random models match rays in perspective views") {
  check(random_models(101, view::Projection::perspective), 1000);
}

TEST_CASE("drawing mirrors in mirrors changes colours but no depths") {
  const testing::Setup once = view_of_room(64, 56, view::Projection::orthographic, to_depth(1), room());
  const testing::Setup twice = view_of_room(64, 56, view::Projection::orthographic, to_depth(2), room());
  CHECK_FALSE(same(drawn(room(), once), drawn(room(), twice)));
  CHECK(drawn(room(), once).depth == drawn(room(), twice).depth);
}

TEST_CASE("a picture of mirrors is identical on all machines and with all strategies") {
  testing::Setup setup = view_of_room(32, 28, view::Projection::perspective, to_depth(2), room());
  const observe::Frame first = drawn(room(), setup);
  for (const emit::Strategy strategy : emit::strategies) {
    setup.options.strategy = strategy;
    CHECK(same(drawn(room(), setup), first));
  }
  setup.options.strategy = emit::Strategy::stack;
  setup.has_global_or = false;
  CHECK(same(drawn(room(), setup), first));
  setup.kind = &scan_line::kind;
  CHECK(same(drawn(room(), setup), first));
  setup.kind = &pixel_square::kind;
  setup.square = {7, 5};
  CHECK(same(drawn(room(), setup), first));
}

TEST_CASE("glass in front of a mirror and reflected in it matches ray tracing") {
  const std::string model = "union(){" + room() + tinted({0.3, 0.9, 0.9}, 0.4, box_text({-7, -6, 1}, {1, -5, 6})) + "}";
  const testing::Setup setup = view_of_room(64, 56, view::Projection::orthographic, to_depth(1), model);
  const auto compiled = testing::compile_text(model, setup);
  testing::RayEffects effects;
  effects.mirrors = mirrors_of(setup.options.scene, compiled);
  effects.reflections = 1;
  effects.layers = 20;
  for (const model::Primitive& one : compiled.tree.primitives) effects.opacity.push_back(one.opacity);
  const auto expected = testing::ray_picture(compiled.tree, compiled.scene, setup.options.scene,
                                             {setup.camera, setup.sampling.width, setup.sampling.height}, effects);
  const observe::Frame frame = testing::draw(compiled.program);
  int wrong = 0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    wrong += expected[i].is_certain && testing::colour_error(frame.colour[i], expected[i].colour) > 3.5 ? 1 : 0;
  CHECK(wrong == 0);
}

TEST_CASE("squares without a visible mirror have no mirror instructions") {
  const std::string model = "union(){" + tinted({0.6, 0.5, 0.5}, 1, box_text({0.5, 4, -7}, {7, 5, -1})) +
                            tinted({0.2, 0.3, 0.9}, 1, box_text({9, 0, -15}, {15, 3, -9})) + "}";
  testing::Setup setup = front_view(16, 16, scene_of(mirroring));
  setup.kind = &pixel_square::kind;
  setup.square = {8, 8};
  const auto compiled = testing::compile_text(model, setup);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& instructions = compiled.program.segments[i].instructions;
    const auto charged = std::count_if(instructions.begin(), instructions.end(),
                                       [](const isa::Instruction& one) { return one.origin.effect != isa::no_effect; });
    CHECK((charged > 0) == (i == 0));
  }
}

TEST_CASE("too little memory for mirrors is an error that suggests a fix") {
  testing::Setup setup = view_of_room(64, 56, view::Projection::orthographic, to_depth(1), room());
  setup.memory_bits = 72;
  const std::string message = testing::error_of([&] { (void)testing::compile_text(room(), setup); });
  CHECK_MESSAGE(message.find("--set effects.mirrors.on=false") != message.npos, message);
  setup.memory_bits = 128;
  CHECK_NOTHROW((void)testing::compile_text(room(), setup));
}

TEST_CASE("more than 256 reflections are an error") {
  std::string model = "union(){";
  for (int i = 0; i < 90; ++i) {
    const double x = 2.0 * i;
    model += tinted({0.6, 0.5, 0.5}, 1, box_text({x, 0.1 * i, -20 - 0.1 * i}, {x + 1, 20, -1 - 0.1 * i}));
  }
  const std::string all = model + "}";
  const std::string message = testing::error_of([&] {
    (void)testing::compile_text(all, view_of_room(64, 56, view::Projection::orthographic, to_depth(1), all));
  });
  CHECK_MESSAGE(message.find("more than 256 reflections must be drawn") != message.npos, message);
}
