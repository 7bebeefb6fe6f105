#include "tests/oracle/ray_light.h"

#include "tests/support/test.h"
#include "tests/unit/oracle/stage.h"

using namespace csgsim;
using namespace testing;

namespace {

const std::string wall = box({-9, 5, -7}, {9, 6, 7});
constexpr glm::dvec3 yellow{0.976, 0.843, 0.173};
constexpr glm::dvec3 green{0.616, 0.796, 0.318};

glm::dvec3 middle_of(const std::string& csg, const scene::Scene& scene) {
  Stage stage(csg, scene);
  stage.cast();
  return stage.at(0, 0).colour;
}

scene::Scene with_material(scene::Scene scene, const scene::Material& material) {
  scene::MaterialRule rule;
  rule.material = material;
  scene.materials.push_back(rule);
  return scene;
}

}  // namespace

TEST_CASE("without lights a face gets 0.3 ambient and 0.7 times the default light's cosine") {
  // The default light's direction is 0.36, -0.56, 0.75: of length sqrt(1.0057), 0.75 along the view.
  const double part = 0.3 + 0.7 * 0.75 / std::sqrt(1.0057);
  CHECK(is_near(middle_of(wall, {}), part * yellow));
}

TEST_CASE("walls cut by a subtracted solid are green or in that solid's colour") {
  const std::string cut = box({-1, 4, -1}, {1, 5.5, 1});
  const double part = 0.3 + 0.7 * 0.75 / std::sqrt(1.0057);
  CHECK(is_near(middle_of("difference(){" + wall + cut + "}", {}), part * green));
  const std::string blue = testing::with_colour({0, 0, 1}, cut);
  CHECK(is_near(middle_of("difference(){" + wall + blue + "}", {}), glm::dvec3(0, 0, part)));
}

TEST_CASE("a light adds its colour times the cosine and nothing to a face turned away") {
  scene::Light light = testing::white_light({3, 4, 0});
  light.colour = {1, 0.5, 0};
  light.intensity = 0.5;
  CHECK(is_near(middle_of(wall, scene_with_light(light)), yellow * (0.3 + 0.4 * glm::dvec3(1, 0.5, 0))));
  light.direction = {3, -4, 0};
  CHECK(is_near(middle_of(wall, scene_with_light(light)), yellow * 0.3));
}

TEST_CASE("the ray oracle clamps the sum of lights to white") {
  scene::Scene scene = scene_with_light(testing::white_light({0, 1, 0}));
  scene.lights.push_back(testing::white_light({0, 1, 0}));
  CHECK(is_near(middle_of(testing::with_colour({1, 0.5, 0.1}, wall), scene), {1, 0.85, 0.17}));
}

TEST_CASE("a light in camera axes turns with the camera") {
  scene::Light light = testing::white_light({0, -3, 4});  // downward and away from the eye: 0, 4, -3 of the model
  light.axes = scene::Axes::camera;
  CHECK(is_near(middle_of(wall, scene_with_light(light)), yellow * (0.3 + 0.7 * 0.8)));
}

TEST_CASE("a point light shades a facet as at the mean of its corners") {
  scene::Light light;
  light.kind = scene::LightKind::point;
  light.position = {3, 1, 0};  // the middle is at 0, 5, 0: 5 away, 4 of them along the normal
  Stage stage(wall, scene_with_light(light));
  stage.cast();
  CHECK(is_near(stage.at(0, 0).colour, yellow * (0.3 + 0.7 * 0.8)));
  CHECK(is_near(stage.at(8, 6).colour, yellow * (0.3 + 0.7 * 0.8)));
}

TEST_CASE("a material scales ambient and diffuse light") {
  const scene::Scene scene = scene_with_light(testing::white_light({0, 1, 0}));
  CHECK(is_near(middle_of(wall, with_material(scene, {.ambient = 0.5, .diffuse = 0.25})), yellow * (0.15 + 0.175)));
}

TEST_CASE("a highlight is the light's colour times a power of the half-way cosine") {
  scene::Light light = testing::white_light({1, 0, 0});
  light.direction = {std::sqrt(3.0) / 2, 0.5, 0};  // 60 degrees from the normal; the half-way vector is at 30
  light.colour = {1, 0, 0};
  light.intensity = 0.5;
  const scene::Material shiny{.ambient = 0, .diffuse = 0, .specular = 0.8, .shininess = 6};
  const double highlight = 0.5 * 0.8 * std::pow(0.75, 3);
  CHECK(is_near(middle_of(wall, with_material(scene_with_light(light), shiny)), {highlight, 0, 0}));
}

TEST_CASE("in perspective a facet's highlight is computed at the mean of its corners") {
  const scene::Material shiny{.ambient = 0, .diffuse = 0, .specular = 1, .shininess = 2};
  scene::Light light = testing::white_light({0, 1, 0});
  light.intensity = 0.5;
  // The eye, seen from 0, 5, 0, is at an angle with tangent 3/4 from the normal; half of it has tangent 1/3.
  Stage stage(wall, with_material(scene_with_light(light), shiny));
  stage.shot.camera = {{60, -75, 0}, {0, 5, 0}, view::Projection::perspective};
  stage.cast();
  REQUIRE(stage.at(0, 0).primitive == 0);
  CHECK(is_near(stage.at(0, 0).colour, glm::dvec3(0.5 * 0.9)));
  CHECK(is_near(stage.at(2, 1).colour, glm::dvec3(0.5 * 0.9)));
}

TEST_CASE("the last matching rule sets a primitive's material and colour if it names one") {
  scene::Scene scene = testing::plain_colours();
  const std::string model = testing::with_colour({0, 0.5, 0}, wall);
  scene::MaterialRule all;
  all.colour = glm::dvec3(1, 0, 0);
  scene.materials.push_back(all);
  CHECK(is_near(middle_of(model, scene), {1, 0, 0}));
  scene::MaterialRule half;
  half.of_colour = glm::dvec3(0, 0.5, 0);
  half.material.ambient = 0.5;
  scene.materials.push_back(half);
  CHECK(is_near(middle_of(model, scene), {0, 0.25, 0}));
  scene::MaterialRule elsewhere;
  elsewhere.from_line = 7;
  elsewhere.to_line = 9;
  scene.materials.push_back(elsewhere);
  CHECK(is_near(middle_of(model, scene), {0, 0.25, 0}));
  scene.materials.back().from_line = 1;
  CHECK(is_near(middle_of(model, scene), {0, 0.5, 0}));
}
