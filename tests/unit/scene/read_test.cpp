#include "host/scene/read.h"

#include "host/effects/rows.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

scene::Scene read(const std::string& text) { return scene::read_scene(text, "s.toml", {}, effects::sections()); }

std::string error_in(const std::string& text) {
  return testing::error_of([&] { read(text); });
}

}  // namespace

TEST_CASE("an empty scene file sets nothing") {
  const scene::Scene empty = read("");
  CHECK(empty.lights.empty());
  CHECK(empty.materials.empty());
  CHECK(empty.effects.empty());
  CHECK_FALSE(empty.background.colour);
  CHECK(empty.ambient == scene::Ambient{});
}

TEST_CASE("every section of a scene file is read") {
  const scene::Scene all = read(R"(
[camera]
eye = [1, 2, 3]
projection = "perspective"
near = 0.5
[background]
colour = [0.1, 0.2, 0.3]
[ambient]
intensity = 0.2
[[lights]]
direction = [0, 0, -2]
intensity = 0.9
[[lights]]
kind = "point"
axes = "camera"
position = [4, 5, 6]
colour = [1, 0, 0]
[[materials]]
of_colour = [0, 1, 0]
specular = 0.5
[[materials]]
from_line = 7
opacity = 0.25
[effects.smooth]
least_difference = 3
)");
  CHECK(all.camera.eye == glm::dvec3(1, 2, 3));
  CHECK(all.camera.is_perspective == true);
  CHECK(all.camera.near == 0.5);
  CHECK_FALSE(all.camera.centre);
  CHECK(all.background.colour == glm::dvec3(0.1, 0.2, 0.3));
  CHECK(all.ambient.intensity == 0.2);
  REQUIRE(all.lights.size() == 2);
  CHECK(all.lights[0].direction == glm::dvec3(0, 0, -2));
  CHECK(all.lights[0].intensity == 0.9);
  CHECK(all.lights[1].kind == scene::LightKind::point);
  CHECK(all.lights[1].axes == scene::Axes::camera);
  CHECK(all.lights[1].position == glm::dvec3(4, 5, 6));
  REQUIRE(all.materials.size() == 2);
  CHECK(all.materials[0].of_colour == glm::dvec3(0, 1, 0));
  CHECK(all.materials[0].material.specular == 0.5);
  CHECK_FALSE(all.materials[0].opacity);
  CHECK(all.materials[1].from_line == 7U);
  CHECK(all.materials[1].to_line == 7U);
  CHECK(all.materials[1].opacity == 0.25);
  REQUIRE(all.effects.size() == 1);
  CHECK(all.effects[0].name == "effects.smooth");
  CHECK(all.effects[0].is_on);
}

TEST_CASE("the section of an effect in a scene file can switch it off") {
  const scene::Scene off = read("[effects.smooth]\non = false\n");
  REQUIRE(off.effects.size() == 1);
  CHECK_FALSE(off.effects[0].is_on);
}

TEST_CASE("an error in a scene file is reported with its place and the nearest known key") {
  CHECK(error_in("[camera]\neey = [1, 2, 3]\n").starts_with("s.toml:2:1: unknown key 'camera.eey'"));
  CHECK(error_in("[camera]\neey = [1, 2, 3]\n").ends_with("the keys here are eye, centre, projection, view_all, near"));
  CHECK(error_in("[efects.smooth]\n").find("'effects'") != std::string::npos);
  CHECK(error_in("[effects.smoth]\n").find("there is no effect 'smoth'; did you mean smooth?") != std::string::npos);
  CHECK(error_in("[effects.smooth]\non = 1\n").starts_with("s.toml:2:6: effects.smooth.on is"));
  CHECK(error_in("[ambient]\nintensity = 2\n").starts_with("s.toml:2:13: ambient.intensity"));
  CHECK(error_in("[background]\ncolour = [1, 2]\n").find("a list of 2") != std::string::npos);
  CHECK(error_in("[background]\ncolour = [1, 2, 0]\n").starts_with("s.toml:2:14: background.colour"));
  CHECK(error_in("[[lights]]\nkind = \"lamp\"\n").find("directional, point") != std::string::npos);
  CHECK(error_in("[lights]\n").find("[[lights]]") != std::string::npos);
  CHECK(error_in("lights = 3\n").find("[[lights]]") != std::string::npos);
  CHECK(error_in("[camera\n").starts_with("s.toml:1:"));
}

TEST_CASE("conflicting values in a scene file are reported at their table") {
  CHECK(error_in("\n[[lights]]\nintensity = 1\n").starts_with("s.toml:2:1: a directional light"));
  CHECK(error_in("[[materials]]\nto_line = 4\n").find("add from_line") != std::string::npos);
  CHECK(error_in("[[materials]]\nfrom_line = 4\nto_line = 3\n").find("precedes from_line") != std::string::npos);
  CHECK(error_in("[camera]\nnear = 1\n").find("perspective") != std::string::npos);
  CHECK(error_in("[[effects.cuts]]\nhatch = 9\n").find("add normal") != std::string::npos);
  CHECK(error_in("[[effects.cuts]]\nnormal = [1, 0, 0]\nhatch = 1\n").find("set hatch to 4 or more") !=
        std::string::npos);
}
