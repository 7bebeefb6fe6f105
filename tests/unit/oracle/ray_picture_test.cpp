#include "tests/oracle/ray_picture.h"

#include "tests/oracle/random_model.h"
#include "tests/support/test.h"
#include "tests/unit/oracle/stage.h"

using namespace csgsim;
using namespace testing;

namespace {

const std::string left = with_colour({1, 0, 0}, box({-8, 0, -2}, {2, 3, 2}));
const std::string right = with_colour({0, 1, 0}, box({-2, 0, -2}, {8, 5, 2}));

}  // namespace

TEST_CASE("the order of a union's parts changes only the owner of shared surfaces") {
  Stage one("union(){" + left + right + "}", testing::plain_colours());
  Stage other("union(){" + right + left + "}", testing::plain_colours());
  one.cast();
  other.cast();
  for (std::int32_t x = -11; x <= 11; ++x) {
    for (std::int32_t z = -11; z <= 11; ++z) {
      const bool is_shared = std::abs(x) < 2 && std::abs(z) < 2;
      CHECK(one.at(x, z).depth == other.at(x, z).depth);
      if (!one.at(x, z).is_certain || !other.at(x, z).is_certain) continue;
      CHECK((one.at(x, z).colour == other.at(x, z).colour) != is_shared);
    }
  }
  CHECK(is_near(one.at(0, 0).colour, {1, 0, 0}));
  CHECK(is_near(other.at(0, 0).colour, {0, 1, 0}));
}

TEST_CASE("a solid minus itself is certainly background") {
  Stage stage("difference(){" + left + left + "}");
  stage.cast();
  for (const std::int32_t x : {-5, 0, 5}) {
    CHECK(stage.at(x, 0).primitive == model::no_index);
    CHECK(is_near(stage.at(x, 0).colour, {1, 1, 0.898}));
    CHECK(stage.at(x, 0).is_certain);
  }
}

TEST_CASE("a pixel within the requested distance of an edge is in doubt") {
  Stage stage(box({-4.6, 0, -4.6}, {4.05, 1, 4.6}), testing::plain_colours());
  stage.cast({}, {0.01, 1e-4});
  CHECK(stage.at(4, 0).is_certain);
  stage.cast({}, {0.1, 1e-4});
  CHECK_FALSE(stage.at(4, 0).is_certain);
  CHECK(stage.at(3, 0).is_certain);
  CHECK(stage.at(5, 0).is_certain);
}

TEST_CASE("the background is in doubt where a solid may be in front of it") {
  const std::string sheet = "intersection(){" + box({-5, 0, -5}, {5, 1, 5}) + box({-5, 1.001, -5}, {5, 2, 5}) + "}";
  Stage stage(sheet);
  stage.cast({}, {0.01, 1e-4});
  CHECK(stage.at(0, 0).primitive == model::no_index);
  CHECK(stage.at(0, 0).is_certain);
  stage.cast({}, {0.01, 1e-2});
  CHECK(stage.at(0, 0).primitive == model::no_index);
  CHECK_FALSE(stage.at(0, 0).is_certain);
}

TEST_CASE("samples are rounded to 8 bits before averaging") {
  Stage stage(with_colour({0.21, 1, 0}, box({-8, 0, -8}, {0.1, 1, 8})), testing::plain_colours());
  stage.shot.samples = {{-0.25, -0.25}, {0.25, -0.25}, {-0.25, 0.25}, {-0.25, 0.4}};
  stage.cast();
  // Three of four samples hit it; 0.21 is 53.55 of 255.
  CHECK(is_near(stage.at(0, 0).colour, {0.75 * 54 / 255, 0.75, 0}));
  CHECK(is_near(stage.at(-2, 0).colour, {54.0 / 255, 1, 0}));
  CHECK(is_near(stage.at(2, 0).colour, {0, 0, 0}));
  CHECK(stage.at(0, 0).primitive == 0);
  stage.shot.samples = {{0.25, 0}, {-0.25, 0}};
  stage.cast();
  CHECK(stage.at(0, 0).primitive == model::no_index);
  stage.shot.samples = {{0, 0}};
  stage.cast();
  CHECK(is_near(stage.at(0, 0).colour, {0.21, 1, 0}));
}

TEST_CASE("sample offsets point right and down from the pixel's centre") {
  Stage stage(with_colour({0, 1, 0}, box({0.1, 0, -8}, {8, 1, -0.1})), testing::plain_colours());
  stage.shot.samples = {{0.25, 0.25}};
  stage.cast();
  CHECK(is_near(stage.at(0, 0).colour, {0, 1, 0}));
  stage.shot.samples = {{0.25, -0.25}};
  stage.cast();
  CHECK(is_near(stage.at(0, 0).colour, {0, 0, 0}));
}

TEST_CASE("in perspective the near plane hides nearer surfaces and cut ones are in doubt") {
  Stage stage("union(){" + left + with_colour({0, 1, 0}, box({-8, 20, -2}, {8, 25, 2})) + "}",
              testing::plain_colours());
  stage.shot.camera = {{0, -30, 0}, {0, 0, 0}, view::Projection::perspective};
  stage.cast();
  CHECK(is_near(stage.at(0, 0).colour, {1, 0, 0}));
  CHECK(stage.at(0, 0).depth == doctest::Approx(30));
  stage.shot.near = 35;
  stage.cast();
  CHECK(is_near(stage.at(0, 0).colour, {0, 1, 0}));
  CHECK(stage.at(0, 0).depth == doctest::Approx(50));
  CHECK(stage.at(0, 0).is_certain);
  stage.shot.near = 31;
  stage.cast();
  CHECK(stage.at(0, 0).primitive == 0);
  CHECK_FALSE(stage.at(0, 0).is_certain);
}

TEST_CASE("colours fade between two distances and the background does not") {
  Stage stage("union(){" + with_colour({1, 0, 0}, box({-8, 2, -8}, {-4, 3, 8})) +
                  with_colour({1, 0, 0}, box({-3, 6, -8}, {3, 7, 8})) +
                  with_colour({1, 0, 0}, box({4, 11, -8}, {8, 12, 8})) + "}",
              testing::plain_colours());
  stage.cast();
  const double origin = stage.at(-6, 0).depth - 2.0;
  testing::RayEffects effects;
  effects.cue = testing::RayCue{origin + 3, origin + 7, {0, 0, 1}};
  stage.cast(effects);
  CHECK(is_near(stage.at(-6, 0).colour, {1, 0, 0}));
  CHECK(is_near(stage.at(0, 0).colour, {0.25, 0, 0.75}));
  CHECK(is_near(stage.at(6, 0).colour, {0, 0, 1}));
  CHECK(is_near(stage.at(0, 10).colour, {0, 0, 0}));
}

TEST_CASE("opaque layers and shadowless lights and reflectionless mirrors change no pixel") {
  Stage stage(testing::random_model(11, 9));
  Stage other(testing::random_model(11, 9));
  stage.cast();
  testing::RayEffects effects;
  effects.has_shadows = true;
  effects.shadowless_lights = {0};
  effects.opacity.assign(stage.tree.primitives.size(), 1.0);
  effects.layers = 5;
  effects.is_there = [](std::uint32_t, std::uint32_t, std::uint32_t) { return true; };
  effects.mirrors = {{0, std::nullopt, 0}};
  effects.reflections = 3;
  other.cast(effects);
  for (std::int32_t x = -11; x <= 11; ++x) {
    for (std::int32_t z = -11; z <= 11; ++z) {
      CHECK(stage.at(x, z).colour == other.at(x, z).colour);
      CHECK(stage.at(x, z).is_certain == other.at(x, z).is_certain);
    }
  }
}
