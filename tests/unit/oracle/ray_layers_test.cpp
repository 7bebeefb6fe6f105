#include "tests/support/test.h"
#include "tests/unit/oracle/stage.h"

using namespace csgsim;
using namespace testing;

namespace {

constexpr glm::dvec3 red{1, 0, 0};
constexpr glm::dvec3 green{0, 1, 0};
constexpr glm::dvec3 blue{0, 0, 1};

std::string pane(const glm::dvec3& colour, double from, double to) {
  return with_colour(colour, box({-5, from, -5}, {5, to, 5}));
}

scene::Scene on_white() {
  scene::Scene scene = testing::plain_colours();
  scene.background.colour = glm::dvec3(1);
  return scene;
}

glm::dvec3 seen_through(const std::string& csg, const std::vector<double>& opacity, unsigned layers) {
  Stage stage(csg, on_white());
  testing::RayEffects effects;
  effects.opacity = opacity;
  effects.layers = layers;
  stage.cast(effects);
  CHECK(stage.at(0, 0).is_certain);
  return stage.at(0, 0).colour;
}

}  // namespace

TEST_CASE("a wall and two panes are weighted by the transmission of the panes in front") {
  const std::string model = "union(){" + pane(red, -5, -4) + pane(green, -2, -1) + pane(blue, 5, 6) + "}";
  const std::vector<double> opacity{0.5, 0.25, 1};
  CHECK(is_near(seen_through(model, opacity, 4), {0.5, 0.125, 0.375}));
  CHECK(is_near(seen_through(model, opacity, 3), {0.5, 0.125, 0.375}));
  CHECK(is_near(seen_through(model, opacity, 2), {0.875, 0.5, 0.375}));
  CHECK(is_near(seen_through(model, opacity, 1), {1, 0.5, 0.5}));
}

TEST_CASE("the ray oracle's transparency does not depend on the order of the model's parts") {
  const std::string model = "union(){" + pane(blue, 5, 6) + pane(green, -2, -1) + pane(red, -5, -4) + "}";
  CHECK(is_near(seen_through(model, {1, 0.25, 0.5}, 4), {0.5, 0.125, 0.375}));
}

TEST_CASE("the ray oracle shows nothing behind an opaque surface") {
  const std::string model = "union(){" + pane(red, -5, -4) + pane(green, -2, -1) + "}";
  CHECK(is_near(seen_through(model, {1, 0.25}, 4), red));
  CHECK(is_near(seen_through(model, {}, 4), red));
}

TEST_CASE("a cavity in glass shows the wall behind it in the colour of the removed solid") {
  const std::string model =
      "difference(){" + pane(red, -5, -1) + with_colour(green, box({-2, -4, -2}, {2, -2, 2})) + "}";
  CHECK(is_near(seen_through(model, {0.5, 0.5}, 4), glm::dvec3(0.5, 0.25, 0) + 0.25));
}

TEST_CASE("coincident faces are one transparent layer of the first primitive in tree order") {
  const std::string model = "union(){" + pane(red, -5, -4) + pane(green, -5, -1) + "}";
  CHECK(is_near(seen_through(model, {0.5, 1}, 4), {1, 0.5, 0.5}));
}

TEST_CASE("each of two touching panes has a visible front") {
  const std::string model = "union(){" + pane(red, -5, -4) + pane(green, -4, -1) + "}";
  CHECK(is_near(seen_through(model, {0.5, 1}, 4), {0.5, 0.5, 0}));
}

TEST_CASE("a screen door shows the first surface that is drawn at the pixel") {
  Stage stage("union(){" + pane(red, -5, -4) + pane(green, -2, -1) + "}", on_white());
  testing::RayEffects effects;
  effects.is_there = [](std::uint32_t x, std::uint32_t y, std::uint32_t primitive) {
    return (x + y) % 2 == 0 && (primitive == 1 || x % 2 == 0);
  };
  stage.cast(effects);
  for (std::int32_t x = -4; x <= 4; ++x) {
    for (std::int32_t z = -4; z <= 4; ++z) {
      const bool even = (x + z) % 2 == 0;  // columns and rows are 12 from x and z
      const glm::dvec3 expected = !even ? glm::dvec3(1) : x % 2 == 0 ? red : green;
      CHECK(is_near(stage.at(x, z).colour, expected));
    }
  }
}

TEST_CASE("layers closer than the gap are in doubt even if the nearest surface is not") {
  Stage stage("union(){" + pane(red, -5, -4) + pane(green, 3, 4) + pane(blue, 3.001, 5) + "}", on_white());
  testing::RayEffects effects;
  effects.opacity = {0.5, 1, 1};
  effects.layers = 2;
  stage.cast(effects, {0.01, 1e-4});
  CHECK(stage.at(0, 0).is_certain);
  CHECK(stage.at(0, 0).primitive == 0);
  CHECK(stage.y_at(0, 0) == doctest::Approx(-5));
  stage.cast(effects, {0.01, 1e-2});
  CHECK_FALSE(stage.at(0, 0).is_certain);
  effects.layers = 1;
  stage.cast(effects, {0.01, 1e-2});
  CHECK(stage.at(0, 0).is_certain);
}
