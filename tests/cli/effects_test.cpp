#include <cstdint>
#include <string>
#include <vector>

#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string small = " --camera 65,-95,60,0,0,-2 --size 48x32 ";

/// Two effects beside flat shading, with room for both.
std::string two_effects(const Folder& folder) {
  write(folder / "scene.toml", "[effects.smooth]\n[effects.shadows]\n");
  return "--scene " + (folder / "scene.toml") + " --memory-bits 256 ";
}

bool draws_the_same(const Folder& folder, const std::string& with) {
  const std::string options = model("old_example002") + small + two_effects(folder);
  REQUIRE(run("render " + options + "-o " + (folder / "plain.ppm")).code == 0);
  const Outcome other = run("render " + options + with + " -o " + (folder / "other.ppm"));
  CAPTURE(other.err);
  REQUIRE(other.code == 0);
  return content(folder / "plain.ppm") == content(folder / "other.ppm");
}

}  // namespace

TEST_CASE("the bill has a row an effect, adds up, and has the picture without each") {
  const Folder folder;
  const Outcome outcome =
      run("effects " + model("old_example002") + small + two_effects(folder) + "-o " + (folder / "bill"));
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  const nlohmann::json bill = json(folder / "bill/effects.json");
  REQUIRE(bill["effects"].size() == 3);
  std::uint64_t clocks = bill["solids"]["clocks"];
  for (const nlohmann::json& row : bill["effects"]) {
    clocks += row["clocks"].get<std::uint64_t>();
    CHECK(outcome.out.find(row["effect"].get<std::string>()) != std::string::npos);
  }
  CHECK(clocks == bill["total"]["clocks"]);
  CHECK(bill["clocks"] > bill["clocks_without_effects"]);
  for (const char* name : {"all", "none", "without_smooth", "without_shadows"})
    CHECK_FALSE(content(folder / ("bill/" + std::string(name) + ".png")).empty());
  CHECK(content(folder / "bill/all.png") != content(folder / "bill/without_shadows.png"));
  CHECK(content(folder / "bill/all.png") != content(folder / "bill/without_smooth.png"));
}

TEST_CASE("what a bill calls the frame without an effect is what render draws with it off") {
  const Folder folder;
  const std::string options = model("old_example002") + small + two_effects(folder);
  REQUIRE(run("effects " + options + "-o " + (folder / "bill")).code == 0);
  REQUIRE(run("render " + options + "--set effects.shadows.on=false --stats " + (folder / "s.json") + " -o " +
              (folder / "p.png"))
              .code == 0);
  const nlohmann::json bill = json(folder / "bill/effects.json");
  CHECK(bill["clocks"].get<std::uint64_t>() - bill["effects"][2]["together_clocks"].get<std::uint64_t>() ==
        json(folder / "s.json")["clocks"]);
  CHECK(content(folder / "bill/without_shadows.png") == content(folder / "p.png"));
}

TEST_CASE("effects draw the same picture at each level and on each machine whose host divides") {
  const Folder folder;
  CHECK(draws_the_same(folder, "--level cycle"));
  CHECK(draws_the_same(folder, "--level reference"));
  CHECK(draws_the_same(folder, "--machine scan-line"));
  CHECK(draws_the_same(folder, "--machine pixel-square+divider.kind=host"));
  CHECK(draws_the_same(folder, "--machine pixel-square+divider.kind=host --level cycle"));
  CHECK(draws_the_same(folder, "--machine pixel-planes-5+divider.kind=host --level cycle"));
}

TEST_CASE("a scene that is wrong ends with its place and exit code 1, what is set wrongly with exit code 2") {
  const Folder folder;
  write(folder / "scene.toml", "[effects.shadow]\n");
  const std::string render = "render " + model("old_example002") + small;
  const Outcome wrong = run(render + "--scene " + (folder / "scene.toml"));
  CHECK(wrong.code == 1);
  CHECK(wrong.err.find("scene.toml:1:") != std::string::npos);
  CHECK(wrong.err.find("there is no effect 'shadow'; did you mean shadows?") != std::string::npos);
  CHECK(one_line(wrong.err));
  CHECK(run(render + "--scene " + (folder / "none.toml")).code == 1);
  misused(render + "--set effects.shadow.on=true", "did you mean shadows?");
  misused(render + "--set ambient.intensity=7", "ambient.intensity");
}

TEST_CASE("a machine that lacks something says what, and which one has it") {
  const Folder folder;
  const std::string render = "render " + model("old_example002") + small + "--set effects.shadows.on=true ";
  const Outcome divides = run(render + "--machine pixel-square");
  CHECK(divides.code == 1);
  CHECK(divides.err.find("pixel-planes-4") != std::string::npos);
  CHECK(divides.err.find("--set effects.shadows.on=false") != std::string::npos);
  const Outcome few = run(render + "--machine pixel-planes-4 --memory-bits 60");
  CHECK(few.code == 1);
  CHECK(few.err.find("owner") != std::string::npos);
  const Outcome asks = run("render " + model("old_example002") + small +
                           "--memory-bits 256 --set effects.equalise.on=true --machine scan-line");
  CHECK(asks.code == 1);
  CHECK(asks.err.find("global OR") != std::string::npos);
}

TEST_CASE("alpha in a model calls for transparency by itself, and can be told not to") {
  const Folder folder;
  write(folder / "m.csg", "color([1,0,0,0.5]){cube(size=[4,4,4],center=true);}cube(size=[9,1,9],center=true);");
  const std::string render = "render " + (folder / "m.csg") + " --size 32x32 --memory-bits 256 --stats " +
                             (folder / "s.json") + " -o " + (folder / "p.png") + " ";
  REQUIRE(run(render).code == 0);
  CHECK(json(folder / "s.json")["effects"] == nlohmann::json::array({"flat", "transparency"}));
  const Outcome judged = run(render + "--check");
  CHECK(judged.code == 1);
  CHECK(judged.err.find("--set effects.transparency.on=false") != std::string::npos);
  REQUIRE(run(render + "--check --set effects.transparency.on=false").code == 0);
  CHECK(json(folder / "s.json")["effects"] == nlohmann::json::array({"flat"}));
}
