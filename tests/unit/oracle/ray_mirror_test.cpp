#include "tests/support/test.h"
#include "tests/unit/oracle/stage.h"

using namespace csgsim;
using namespace testing;

namespace {

constexpr glm::dvec3 grey{0.4, 0.4, 0.4};
constexpr glm::dvec3 red{1, 0, 0};

/// A slab whose front face is x + y = 0: it turns the view to the left.
const std::string mirror = with_colour(
    grey,
    "multmatrix([[0.7071067811865476,0.7071067811865476,0,0],[-0.7071067811865476,0.7071067811865476,0,0],[0,0,1,0],"
    "[0,0,0,1]]){" +
        box({-6, 0, -4.5}, {6, 1, 4.5}) + "}");

/// A cube to the left of the mirror; its right face is at x = -7. The pixel at x shows the point y = -x.
const std::string cube = with_colour(red, box({-9, -0.5, -0.5}, {-7, 2.5, 1.5}));

const std::string both = "union(){" + mirror + cube + "}";

testing::RayEffects mirroring(double reflectance, unsigned reflections = 1) {
  testing::RayEffects effects;
  effects.mirrors = {{0, std::nullopt, reflectance}};
  effects.reflections = reflections;
  return effects;
}

}  // namespace

TEST_CASE("a mirror at 45 degrees shows a cube at its mirror image") {
  Stage stage(both, testing::plain_colours());
  stage.cast(mirroring(0.75));
  for (std::int32_t x = -4; x <= 3; ++x) {
    for (std::int32_t z = -3; z <= 3; ++z) {
      const bool is_image = x >= -2 && x <= 0 && z >= 0 && z <= 1;
      CAPTURE(x);
      CAPTURE(z);
      CHECK(is_near(stage.at(x, z).colour, 0.25 * grey + (is_image ? 0.75 * red : glm::dvec3(0))));
      CHECK(stage.at(x, z).primitive == 0);
      CHECK(stage.at(x, z).is_certain);
    }
  }
  CHECK(is_near(stage.at(-8, 0).colour, red));
}

TEST_CASE("the edge of a mirrored object is in doubt") {
  Stage stage("union(){" + mirror + box({-9, -1, -0.5}, {-7, 2.5, 1.5}) + "}", testing::plain_colours());
  stage.cast(mirroring(0.75));
  CHECK_FALSE(stage.at(1, 0).is_certain);
  CHECK(stage.at(1, 3).is_certain);
}

TEST_CASE("a doubtful surface is in doubt in a mirror as well") {
  const std::string sheet = box({-7, -0.5, -0.5}, {-6.999, 2.5, 1.5});
  Stage stage("union(){" + mirror + cube + sheet + "}", testing::plain_colours());
  stage.cast(mirroring(0.75), {0.01, 1e-4});
  CHECK(stage.at(-1, 0).is_certain);
  stage.cast(mirroring(0.75), {0.01, 1e-2});
  CHECK_FALSE(stage.at(-1, 0).is_certain);
  CHECK(stage.at(3, 0).is_certain);
}

TEST_CASE("without reflections a mirror shows its own colour") {
  Stage stage(both, testing::plain_colours());
  stage.cast(mirroring(0.75, 0));
  CHECK(is_near(stage.at(-1, 0).colour, grey));
}

TEST_CASE("only facets of mirrors reflect") {
  Stage stage(both, testing::plain_colours());
  stage.cast();
  const std::uint32_t front = stage.at(-1, 0).halfspace;
  testing::RayEffects effects = mirroring(0.75);
  effects.mirrors.front().halfspace = front;
  stage.cast(effects);
  CHECK(is_near(stage.at(-1, 0).colour, 0.25 * grey + 0.75 * red));
  effects.mirrors.front().halfspace = front + 1;
  stage.cast(effects);
  CHECK(is_near(stage.at(-1, 0).colour, grey));
}

TEST_CASE("mirrors reflect mirrors up to the requested depth") {
  Stage stage(both, testing::plain_colours());
  testing::RayEffects effects = mirroring(0.75, 1);
  effects.mirrors.push_back({1, std::nullopt, 0.5});
  stage.cast(effects);
  CHECK(is_near(stage.at(-1, 0).colour, 0.25 * grey + 0.75 * red));
  effects.reflections = 2;  // the cube's face reflects the view back along its path
  stage.cast(effects);
  CHECK(is_near(stage.at(-1, 0).colour, 0.25 * grey + 0.75 * (0.5 * red + 0.5 * grey)));
}

TEST_CASE("a mirror does not show objects behind it") {
  const std::string behind = with_colour(red, box({-3, 4, -3}, {4, 6, 3}));
  Stage stage("union(){" + mirror + behind + "}", testing::plain_colours());
  stage.cast(mirroring(0.75));
  CHECK(is_near(stage.at(0, 0).colour, 0.25 * grey));
}

TEST_CASE("in a mirror the light keeps its place and highlights use the mirrored eye") {
  scene::Scene scene;
  scene.background.colour = glm::dvec3(0);
  scene.lights.push_back(testing::white_light({-1, 0, 0}));
  scene.lights.front().intensity = 0.5;
  scene::MaterialRule shiny;
  shiny.material = {.ambient = 1, .diffuse = 1, .specular = 0.2, .shininess = 100};
  scene.materials.push_back(shiny);
  Stage stage(both, scene);
  stage.cast(mirroring(1));
  // The mirrored eye looks at the cube's right face from the direction of the light.
  CHECK(is_near(stage.at(-1, 0).colour, (0.3 + 0.5) * red + 0.1));
}

TEST_CASE("a mirrored point is shadowed at its place and faded by the whole path") {
  scene::Scene scene;
  scene.background.colour = glm::dvec3(0);
  scene.lights.push_back(testing::white_light({-1, 0, -1}));
  const std::string roof = box({-4.8, -3, 3}, {-4.2, 3, 4});  // between the right face of the cube and the light
  Stage stage("union(){" + mirror + cube + roof + "}", scene);
  testing::RayEffects effects = mirroring(1);
  stage.cast(effects);
  const double lit = 0.3 + 0.7 / std::sqrt(2.0);
  for (const std::int32_t z : {0, 1}) CHECK(is_near(stage.at(-1, z).colour, lit * red));
  effects.has_shadows = true;
  stage.cast(effects);
  // From (-7, y, z) the path to the light is at x = 3 - z - 7 when it reaches the roof's height, and 1 farther when it
  // leaves it.
  CHECK(is_near(stage.at(-1, 1).colour, 0.3 * red));
  CHECK(is_near(stage.at(-1, 0).colour, lit * red));

  // The mirror at x = -1 is at y = 1, 6 away from the cube.
  const double eye_to_origin = stage.at(-1, 1).depth - 1.0;
  effects.cue = testing::RayCue{eye_to_origin + 5, eye_to_origin + 13, {0, 0, 1}};
  effects.has_shadows = false;
  stage.cast(effects);
  CHECK(is_near(stage.at(-1, 0).colour, lit * red * 0.75 + glm::dvec3(0, 0, 0.25)));
}

TEST_CASE("in perspective a mirror image is as far behind the mirror as the object before") {
  // A mirror across the view, and a cube behind the eye, as seen from the mirror image of the eye.
  const std::string across = with_colour(grey, box({-50, 40, -50}, {50, 41, 50}));
  const std::string thing = with_colour(red, box({4, -5, 2}, {9, 0, 6}));
  Stage stage("union(){" + across + thing + "}", testing::plain_colours());
  stage.shot.camera = {{0, 10, 0}, {0, 40, 0}, view::Projection::perspective};
  stage.cast(mirroring(0.5));
  // Mirrored, its nearest face is at y = 80, 70 from the eye, where a pixel is 140 tan(11.25 deg) / 25 = 1.1139. Only
  // that face is visible: the others are behind it or face away from the axis.
  const double pixel = 140 * view::half_height_per_distance() / 25;
  int images = 0;
  for (std::int32_t x = -11; x <= 11; ++x) {
    for (std::int32_t z = -11; z <= 11; ++z) {
      if (!stage.at(x, z).is_certain) continue;
      const bool faces = x * pixel > 4 && x * pixel < 9 && z * pixel > 2 && z * pixel < 6;
      const double far = pixel * 75 / 70;  // the left and lower sides extend to 75 from the eye
      const bool sides = x * far > 4 && x * far < 9 && z * far > 2 && z * far < 6;
      CAPTURE(x);
      CAPTURE(z);
      CHECK(is_near(stage.at(x, z).colour, 0.5 * grey + (faces || sides ? 0.5 * red : glm::dvec3(0))));
      images += faces ? 1 : 0;
    }
  }
  CHECK(images >= 9);
}
