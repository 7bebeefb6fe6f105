#include "host/effects/rows.h"
#include "host/scene/read.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

scene::Scene set(const std::vector<std::string>& sets, const std::string& text = "") {
  return scene::read_scene(text, "s.toml", sets, effects::sections());
}

std::string error_of_set(const std::string& one) {
  return testing::error_of([&] { set({one}); });
}

}  // namespace

TEST_CASE("a key given with --set replaces that of the scene file or is added") {
  const std::string text = "[[lights]]\ndirection = [1, 0, 0]\nintensity = 0.5\n";
  const scene::Scene one = set({"lights.0.direction=[0, 0, -1]", "ambient.intensity=0"}, text);
  REQUIRE(one.lights.size() == 1);
  CHECK(one.lights[0].direction == glm::dvec3(0, 0, -1));
  CHECK(one.lights[0].intensity == 0.5);
  CHECK(one.ambient.intensity == 0);
}

TEST_CASE("lists and words given with --set need no brackets and quotes") {
  const scene::Scene one = set({"lights.0.kind=point", "lights.0.position=1,2,3", "camera.projection=perspective"});
  REQUIRE(one.lights.size() == 1);
  CHECK(one.lights[0].kind == scene::LightKind::point);
  CHECK(one.lights[0].position == glm::dvec3(1, 2, 3));
  CHECK(one.camera.is_perspective == true);
}

TEST_CASE("the next number appends a table to a list and the last of equal keys counts") {
  const scene::Scene two =
      set({"lights.0.direction=1,0,0", "lights.1.direction=0,1,0", "lights.1.intensity=0.1", "lights.1.intensity=0.2"});
  REQUIRE(two.lights.size() == 2);
  CHECK(two.lights[1].direction == glm::dvec3(0, 1, 0));
  CHECK(two.lights[1].intensity == 0.2);
}

TEST_CASE("a key given with --set requests an effect or switches it off") {
  CHECK(set({"effects.smooth.least_difference=2"}).effects.at(0).is_on);
  CHECK_FALSE(set({"effects.smooth.on=false"}, "[effects.smooth]\n").effects.at(0).is_on);
}

TEST_CASE("an error in a key given with --set is reported together with the key") {
  CHECK(error_of_set("lights").find("KEY=VALUE") != std::string::npos);
  CHECK(error_of_set("lights.5.intensity=1").find("count from 0") != std::string::npos);
  CHECK(error_of_set("camera.eey=1,2,3").find("the keys here are eye, centre") != std::string::npos);
  CHECK(error_of_set("camera..eye=1,2,3").find("separated by single dots") != std::string::npos);
  CHECK(error_of_set("ambient.intensity=2").find("ambient.intensity=2") != std::string::npos);
  CHECK(error_of_set("ambient.intensity.x=2").find("unknown key") == std::string::npos);
  CHECK_FALSE(error_of_set("ambient.intensity.x=2").empty());
  CHECK(error_of_set("lights.0=3").find("'0' is below a list") != std::string::npos);
}

TEST_CASE("a key given with --set has at most eight parts") {
  CHECK(error_of_set("a.b.c.d.e.f.g.h=1").find("more than 8 parts") == std::string::npos);
  CHECK_FALSE(error_of_set("a.b.c.d.e.f.g.h=1").empty());
  CHECK(error_of_set("a.b.c.d.e.f.g.h.i=1").find("more than 8 parts") != std::string::npos);
}

TEST_CASE("an unknown table in a key given with --set is reported with the key") {
  CHECK_THROWS_AS(set({"effects.smoth.on=true"}), scene::SetError);
  CHECK(error_of_set("effects.smoth.on=true").find("--set effects.smoth.on=true") != std::string::npos);
  CHECK_THROWS_AS(set({"lihgts.0.intensity=1"}), scene::SetError);
}
