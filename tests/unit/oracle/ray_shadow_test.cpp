#include "tests/support/test.h"
#include "tests/unit/oracle/stage.h"

using namespace csgsim;
using namespace testing;

namespace {

const std::string wall = testing::with_colour({0.5, 0.5, 0.5}, box({-11.5, 5, -11.5}, {11.5, 6, 11.5}));

testing::RayEffects shadows() {
  testing::RayEffects effects;
  effects.has_shadows = true;
  return effects;
}

/// Whether a pixel of the wall gets more than ambient light.
bool is_lit(const Stage& stage, std::int32_t x, std::int32_t z) {
  CAPTURE(x);
  CAPTURE(z);
  CHECK(stage.at(x, z).primitive == 0);
  CHECK(stage.at(x, z).is_certain);
  const double red = stage.at(x, z).colour.x;
  const bool is_dark = std::abs(red - 0.5 * 0.3) < 1e-9;
  CHECK((is_dark || red > 0.5 * 0.5));
  return !is_dark;
}

/// A light that shines to the right and away from the eye: from the wall at y = 5 the path to it has x falling with y.
const scene::Light slanted = testing::white_light({1, 1, 0});

scene::Light lamp(const glm::dvec3& position) {
  scene::Light light;
  light.kind = scene::LightKind::point;
  light.position = position;
  return light;
}

}  // namespace

TEST_CASE("a box casts its slanted shadow on the wall and none on itself") {
  Stage stage("union(){" + wall + box({-1.5, 0, -1.5}, {1.5, 1, 1.5}) + "}", scene_with_light(slanted));
  stage.cast(shadows());
  // The box lies 4 to 5 to the left along the path: x from 2.5 to 6.5.
  for (const std::int32_t z : {-1, 0, 1}) {
    CHECK(is_lit(stage, 2, z));
    for (const std::int32_t x : {3, 4, 5, 6}) CHECK_FALSE(is_lit(stage, x, z));
    CHECK(is_lit(stage, 7, z));
    CHECK(is_lit(stage, -4, z));
  }
  for (const std::int32_t x : {2, 4, 6}) CHECK(is_lit(stage, x, 2));
  CHECK(stage.at(0, 0).primitive == 1);
  CHECK(stage.at(0, 0).colour.x > 0.976 * 0.5);
}

TEST_CASE("a wall behind a box is lit without shadows and by shadowless lights") {
  Stage stage("union(){" + wall + box({-1.5, 0, -1.5}, {1.5, 1, 1.5}) + "}", scene_with_light(slanted));
  stage.cast();
  CHECK(is_lit(stage, 4, 0));
  testing::RayEffects effects = shadows();
  effects.shadowless_lights = {0};
  stage.cast(effects);
  CHECK(is_lit(stage, 4, 0));
  effects.shadowless_lights = {1};
  stage.cast(effects);
  CHECK_FALSE(is_lit(stage, 4, 0));
}

TEST_CASE("light passes through a hole as far as the hole's walls allow") {
  const std::string plate = box({-3.5, 0, -3.5}, {3.5, 1, 3.5});
  const std::string hole = box({-1.5, -1, -1.5}, {1.5, 2, 1.5});
  Stage stage("union(){" + wall + "difference(){" + plate + hole + "}}", scene_with_light(slanted));
  stage.cast(shadows());
  // The plate shades 0.5 to 8.5; through the hole the path is free from 3.5 (its far end) to 5.5 (its near end).
  for (const std::int32_t z : {-1, 0, 1}) {
    CHECK(is_lit(stage, 0, z));  // seen through the hole
    CHECK_FALSE(is_lit(stage, 1, z));
    CHECK(is_lit(stage, 4, z));
    CHECK(is_lit(stage, 5, z));
    for (const std::int32_t x : {6, 7, 8}) CHECK_FALSE(is_lit(stage, x, z));
    CHECK(is_lit(stage, 9, z));
  }
  for (const std::int32_t z : {-3, -2, 2, 3}) {
    for (const std::int32_t x : {4, 5, 8}) CHECK_FALSE(is_lit(stage, x, z));
  }
}

TEST_CASE("a subtracted solid casts no shadow whatever its size") {
  const std::string cut = box({-9, -4, -9}, {9, 3, 9});
  Stage stage("difference(){" + wall + cut + "}", scene_with_light(slanted));
  stage.cast(shadows());
  for (const std::int32_t x : {-8, 0, 8}) CHECK(is_lit(stage, x, 0));
}

TEST_CASE("a ball's shadow is the ellipse of lines closer than its radius") {
  Stage stage("union(){" + wall + "sphere($fn=96,$fa=12,$fs=2,r=3);}", scene_with_light(slanted));
  stage.cast(shadows());
  int dark = 0;
  for (std::int32_t x = -11; x <= 11; ++x) {
    for (std::int32_t z = -11; z <= 11; ++z) {
      if (stage.at(x, z).primitive != 0 || !stage.at(x, z).is_certain) continue;
      const double squared = (x - 5) * (x - 5) / 2.0 + z * z;
      if (squared > 2.97 * 2.97 && squared < 3 * 3) continue;
      CHECK(is_lit(stage, x, z) == (squared > 9.0));
      dark += squared < 8.0 ? 1 : 0;
    }
  }
  CHECK(dark > 20);
}

TEST_CASE("a point light's shadow grows with distance and its edge is in doubt") {
  Stage stage("union(){" + wall + box({-1.5, 0, -1.5}, {1.5, 1, 1.5}) + "}", scene_with_light(lamp({0, -5, 0})));
  stage.cast(shadows());
  for (const std::int32_t x : {-2, 2}) CHECK_FALSE(is_lit(stage, x, 0));
  for (const std::int32_t x : {-4, 4}) CHECK(is_lit(stage, x, 0));
  CHECK_FALSE(stage.at(3, 0).is_certain);
  CHECK_FALSE(stage.at(-1, 3).is_certain);
}

TEST_CASE("the shadow of a sheet thinner than the gap is in doubt") {
  const std::string sheet = box({-1.5, 0, -1.5}, {1.5, 0.001, 1.5});
  const std::string behind = box({-11.5, 9, -11.5}, {11.5, 10, 11.5});
  Stage stage("union(){" + wall + sheet + behind + "}", scene_with_light(slanted));
  stage.cast(shadows(), {0.01, 1e-4});
  CHECK_FALSE(is_lit(stage, 5, 0));
  stage.cast(shadows(), {0.01, 1e-2});
  CHECK_FALSE(stage.at(5, 0).is_certain);
  CHECK(stage.at(9, 0).is_certain);
  testing::RayEffects effects = shadows();
  effects.opacity = {0.5, 1, 1};
  effects.layers = 2;
  stage.cast(effects, {0.01, 1e-2});
  CHECK_FALSE(stage.at(5, 0).is_certain);
}

TEST_CASE("at grazing light a shadow's edge is in doubt as far as the gap shifts it") {
  // A post on the wall, 0.5 high; the light's slope along the wall is 1 in 20: the shadow is 10 long, from x = 0 to 10.
  Stage stage("union(){" + wall + box({-1, 4.5, -3}, {0, 5, 3}) + "}",
              scene_with_light(testing::white_light({20, 1, 0})));
  const auto is_dark = [&](std::int32_t x) { return std::abs(stage.at(x, 0).colour.x - 0.15) < 1e-9; };
  stage.cast(shadows(), {0.01, 0.02});  // moves the shadow's end by 0.4 pixels
  CHECK(is_dark(9));
  CHECK(stage.at(9, 0).is_certain);
  CHECK_FALSE(is_dark(11));
  CHECK(stage.at(11, 0).is_certain);
  stage.cast(shadows(), {0.01, 0.06});  // moves it by 1.2 pixels
  CHECK(stage.at(8, 0).is_certain);
  CHECK_FALSE(stage.at(9, 0).is_certain);
  CHECK_FALSE(stage.at(11, 0).is_certain);
}

TEST_CASE("objects beyond a point light cast no shadow") {
  Stage stage("union(){" + wall + box({4, -4, -9}, {5, -3, 9}) + "}", scene_with_light(lamp({8, 0, 0})));
  stage.cast(shadows());
  for (const std::int32_t x : {-8, 0, 3, 8}) CHECK(is_lit(stage, x, 0));
}

TEST_CASE("shadows change no colour of a lone ball") {
  const std::string ball = testing::with_colour({0.5, 0.5, 0.5}, "sphere($fn=16,$fa=12,$fs=2,r=8);");
  Stage stage(ball, scene_with_light(slanted));
  Stage plain(ball, scene_with_light(slanted));
  stage.cast(shadows());
  plain.cast();
  for (std::int32_t x = -9; x <= 9; ++x) {
    for (std::int32_t z = -9; z <= 9; ++z) CHECK(stage.at(x, z).colour == plain.at(x, z).colour);
  }
}

TEST_CASE("the bottom of a pit is in the shadow of the pit's wall") {
  const std::string block = testing::with_colour({0.5, 0.5, 0.5}, box({-10, 0, -10}, {10, 9, 10}));
  const std::string pit = testing::with_colour({0.5, 0.5, 0.5}, box({-4.5, -1, -4.5}, {4.5, 3, 4.5}));
  Stage stage("difference(){" + block + pit + "}", scene_with_light(slanted));
  stage.cast(shadows());
  // The bottom is 3 deep: dark for 3 from the left wall at -4.5.
  for (const std::int32_t x : {-4, -3, -2}) CHECK(stage.at(x, 0).colour.x == doctest::Approx(0.15));
  for (const std::int32_t x : {-1, 0, 4}) CHECK(stage.at(x, 0).colour.x > 0.3);
  for (const std::int32_t x : {-6, 6}) CHECK(stage.at(x, 0).colour.x > 0.3);
  CHECK(stage.at(-3, 0).primitive == 1);
}
