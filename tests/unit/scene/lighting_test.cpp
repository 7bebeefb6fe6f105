#include "host/lighting/lighting.h"

#include "tests/support/test.h"

using namespace csgsim;

namespace {

const view::Camera along_y{{0, -10, 0}, {0, 0, 0}, view::Projection::orthographic};

scene::Light towards(const glm::dvec3& direction, double intensity) {
  scene::Light light;
  light.direction = direction;
  light.intensity = intensity;
  return light;
}

glm::dvec3 lit_colour(const scene::Scene& scene, const scene::Material& material, const lighting::SurfacePoint& at) {
  return lighting::lit_colour(lighting::make_lighting(scene, along_y), material, {1, 0.5, 0.25}, at);
}

/// A point that faces the eye.
const lighting::SurfacePoint facing{{0, 0, 10}, {0, 0, -1}};

}  // namespace

TEST_CASE("a surface facing a light gets the light's intensity plus ambient light") {
  scene::Scene scene;
  scene.ambient.intensity = 0.2;
  scene.lights = {towards({0, 3, 0}, 0.6)};
  const glm::dvec3 colour = lit_colour(scene, {}, facing);
  CHECK(colour.r == doctest::Approx(0.8));
  CHECK(colour.g == doctest::Approx(0.4));
  CHECK(colour.b == doctest::Approx(0.2));
}

TEST_CASE("light falls off with the cosine and adds up and is zero on faces turned away") {
  scene::Scene scene;
  scene.ambient.intensity = 0;
  scene.lights = {towards({std::sqrt(3.0), 1, 0}, 1)};
  CHECK(lit_colour(scene, {}, facing).r == doctest::Approx(0.5));
  scene.lights = {towards({0, -1, 0}, 1)};
  CHECK(lit_colour(scene, {}, facing).r == 0);
  scene.lights = {towards({0, 1, 0}, 0.25), towards({std::sqrt(3.0), 1, 0}, 1), towards({0, -1, 0}, 1)};
  CHECK(lit_colour(scene, {}, facing).r == doctest::Approx(0.75));
}

TEST_CASE("a point light shines from its position in either coordinate system") {
  scene::Scene scene;
  scene.ambient.intensity = 0;
  scene::Light light;
  light.kind = scene::LightKind::point;
  light.intensity = 1;
  light.position = {3, -4, 0};  // the point is at the model's origin, 10 in front of the eye
  scene.lights = {light};
  CHECK(lit_colour(scene, {}, facing).r == doctest::Approx(0.8));
  scene.lights[0].axes = scene::Axes::camera;
  scene.lights[0].position = {3, 0, 6};
  CHECK(lit_colour(scene, {}, facing).r == doctest::Approx(0.8));
}

TEST_CASE("a highlight has the light's colour and peaks half-way between light and eye") {
  scene::Scene scene;
  scene.ambient.intensity = 0;
  scene.lights = {towards({0, 1, 0}, 1)};
  scene.lights[0].colour = {0, 1, 0};
  scene::Material shiny;
  shiny.diffuse = 0;
  shiny.specular = 0.5;
  const glm::dvec3 straight = lit_colour(scene, shiny, facing);
  CHECK(straight.r == 0);
  CHECK(straight.g == doctest::Approx(0.5));
  const glm::dvec3 aside = lit_colour(scene, shiny, {{0, 0, 10}, glm::normalize(glm::dvec3(1, 0, -3))});
  CHECK(aside.g < straight.g);
  CHECK(aside.g == doctest::Approx(0.5 * std::pow(3 / std::sqrt(10.0), shiny.shininess)));
}

TEST_CASE("materials apply by colour or by line and the last match counts") {
  model::Primitive primitive;
  primitive.shape = model::Cube{};
  primitive.colour = glm::dvec3(0, 1, 0);
  primitive.location = {5, 1};
  primitive.opacity = 0.5;
  scene::Scene scene;
  CHECK(lighting::make_finish(scene, primitive, false).opacity == 0.5);
  scene::MaterialRule green;
  green.of_colour = glm::dvec3(0, 1, 0);
  green.colour = glm::dvec3(1, 1, 0);
  green.opacity = 0.75;
  scene::MaterialRule line;
  line.from_line = 5;
  line.to_line = 5;
  line.material.specular = 1;
  scene::MaterialRule elsewhere;
  elsewhere.from_line = 6;
  elsewhere.to_line = 9;
  elsewhere.colour = glm::dvec3(0);
  scene.materials = {green, line, elsewhere};
  const lighting::Finish finish = lighting::make_finish(scene, primitive, false);
  CHECK(finish.colour == glm::dvec3(1, 1, 0));
  CHECK(finish.opacity == 0.75);
  CHECK(finish.material.specular == 1);
  primitive.colour.reset();
  CHECK(lighting::make_finish(scene, primitive, true).colour == lighting::default_cut_colour);
}
