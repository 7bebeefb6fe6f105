#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string small = " --camera 65,-95,60,0,0,-2 --size 48x32 ";

/// Options for two effects in addition to flat shading, with enough memory for both.
std::string two_effects(const Folder& folder) {
  write(folder / "scene.toml", "[effects.smooth]\n[effects.shadows]\n");
  return "--scene " + (folder / "scene.toml") + " --memory-bits 256 ";
}

bool draws_the_same(const Folder& folder, const std::string& with) {
  const std::string options = model("old_example002") + small + two_effects(folder);
  require_success(run("render " + options + "-o " + (folder / "plain.ppm")));
  const Outcome other = require_success(run("render " + options + with + " -o " + (folder / "other.ppm")));
  return content(folder / "plain.ppm") == content(folder / "other.ppm");
}

}  // namespace

TEST_CASE("the cost table of effects adds up to the clocks of the frame") {
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

TEST_CASE("effects draws a frame without an effect as render does with the effect off") {
  const Folder folder;
  const std::string options = model("old_example002") + small + two_effects(folder);
  require_success(run("effects " + options + "-o " + (folder / "bill")));
  require_success(run("render " + options + "--set effects.shadows.on=false --stats " + (folder / "s.json") + " -o " +
                      (folder / "p.png")));
  const nlohmann::json bill = json(folder / "bill/effects.json");
  CHECK(bill["clocks"].get<std::uint64_t>() - bill["effects"][2]["together_clocks"].get<std::uint64_t>() ==
        json(folder / "s.json")["clocks"]);
  CHECK(content(folder / "bill/without_shadows.png") == content(folder / "p.png"));
}

TEST_CASE("effects draw the same picture at each level and on machines whose host divides") {
  const Folder folder;
  CHECK(draws_the_same(folder, "--level cycle"));
  CHECK(draws_the_same(folder, "--level reference"));
  CHECK(draws_the_same(folder, "--machine scan-line"));
  CHECK(draws_the_same(folder, "--machine pixel-square+divider.kind=host"));
  CHECK(draws_the_same(folder, "--machine pixel-square+divider.kind=host --level cycle"));
  CHECK(draws_the_same(folder, "--machine pixel-planes-5 --level cycle"));
}

TEST_CASE("a wrong key has exit code 1 and a place in a scene file and code 2 in an option") {
  const Folder folder;
  write(folder / "scene.toml", "[effects.shadow]\n");
  const std::string render = "render " + model("old_example002") + small;
  fails(run(render + "--scene " + (folder / "scene.toml")), 1,
        {"scene.toml:1:", "there is no effect 'shadow'; did you mean shadows?"});
  CHECK(run(render + "--scene " + (folder / "none.toml")).code == 1);
  check_misuse(render + "--set effects.shadow.on=true", "did you mean shadows?");
  check_misuse(render + "--set ambient.intensity=7", "ambient.intensity");
}

TEST_CASE("an error names what a machine lacks for an effect") {
  const Folder folder;
  const std::string render = "render " + model("old_example002") + small + "--set effects.shadows.on=true ";
  fails(run(render + "--machine pixel-square"), 1, {"pixel-planes-4", "--set effects.shadows.on=false"});
  fails(run(render + "--machine pixel-planes-4 --memory-bits 60"), 1, {"owner"});
  fails(run("render " + model("old_example002") + small +
            "--memory-bits 256 --set effects.equalise.on=true --machine scan-line"),
        1, {"global OR"});
}

TEST_CASE("alpha in a model enables transparency unless the scene switches it off") {
  const Folder folder;
  write(folder / "m.csg", "color([1,0,0,0.5]){cube(size=[4,4,4],center=true);}cube(size=[9,1,9],center=true);");
  const std::string render = "render " + (folder / "m.csg") + " --size 32x32 --memory-bits 256 --stats " +
                             (folder / "s.json") + " -o " + (folder / "p.png") + " ";
  require_success(run(render));
  CHECK(json(folder / "s.json")["effects"] == nlohmann::json::array({"flat", "transparency"}));
  fails(run(render + "--check"), 1, {"--set effects.transparency.on=false"});
  require_success(run(render + "--check --set effects.transparency.on=false"));
  CHECK(json(folder / "s.json")["effects"] == nlohmann::json::array({"flat"}));
}

namespace {

/// A red pane in front of a wall, next to a pane in front of the background.
const std::string panes =
    "color([1,0,0,0.5]){cube(size=[4,4,4],center=true);}\n"
    "multmatrix([[1,0,0,0],[0,1,0,9],[0,0,1,0],[0,0,0,1]]){cube(size=[3,1,3],center=true);}\n"
    "color([-1,-1,-1,0.25]){multmatrix([[1,0,0,9],[0,1,0,0],[0,0,1,0],[0,0,0,1]]){cube(size=[4,4,4],center=true);}}\n";
const std::string from_front = " --size 48x32 --camera 4,-50,0,4,0,0 ";

/// The number after the first --memory-bits of a message.
std::string bits_in(const std::string& message) {
  const std::string option = "--memory-bits ";
  const std::size_t at = message.find(option);
  REQUIRE(at != std::string::npos);
  return message.substr(at + option.size(),
                        message.find_first_not_of("0123456789", at + option.size()) - at - option.size());
}

}  // namespace

TEST_CASE("transparency falls back to a screen door with a warning if memory is short") {
  const Folder folder;
  write(folder / "m.csg", panes);
  const std::string render = "render " + (folder / "m.csg") + from_front;
  const Outcome spared = require_success(run(render + "-o " + (folder / "spared.ppm")));
  CHECK(is_one_line(spared.err));
  CHECK(spared.err.find("m.csg: warning: ") != std::string::npos);
  CHECK(spared.err.find("the machine has 72") != std::string::npos);
  const std::string method = "--set effects.transparency.method=";
  CHECK(spared.err.find(method + "screen-door") != std::string::npos);
  const Outcome asked = require_success(run(render + method + "screen-door -o " + (folder / "asked.ppm")));
  CHECK(asked.err.empty());
  CHECK(content(folder / "spared.ppm") == content(folder / "asked.ppm"));

  const std::string bits = bits_in(spared.err);
  const Outcome layers = require_success(run(render + "--memory-bits " + bits + " -o " + (folder / "layers.ppm")));
  CHECK(layers.err.empty());
  CHECK(content(folder / "layers.ppm") != content(folder / "asked.ppm"));
  CHECK(run(render + "--memory-bits " + std::to_string(std::stoi(bits) - 1)).err.find("screen-door") !=
        std::string::npos);
}

TEST_CASE("transparency set in the scene is rejected if memory is short for its layers") {
  const Folder folder;
  write(folder / "m.csg", panes);
  write(folder / "s.toml", "[[materials]]\nfrom_line = 2\nopacity = 0.5\n");
  const std::string render = "render " + (folder / "m.csg") + from_front;
  for (const std::string& said :
       {std::string("--set effects.transparency.method=layers"), std::string("--set effects.transparency.on=true"),
        "--scene " + (folder / "s.toml")}) {
    const Outcome refused = run(render + said);
    CAPTURE(said);
    fails(refused, 1, {"and the machine has 72"});
  }
}

TEST_CASE("--depth and --owner show the nearest surface or the opaque one with --surface") {
  const Folder folder;
  write(folder / "m.csg", panes);
  const auto draw = [&](const std::string& name, const std::string& options) {
    require_success(run("render " + (folder / "m.csg") + from_front + "--depth " + (folder / (name + ".exr")) +
                        " --owner " + (folder / (name + ".png")) + " " + options));
    return json(folder / (name + ".json"));
  };
  const nlohmann::json solid = draw("solid", "--set effects.transparency.on=false");
  const nlohmann::json glass = draw("glass", "--memory-bits 256");
  CHECK(glass == solid);
  CHECK(content(folder / "glass.exr") == content(folder / "solid.exr"));
  CHECK(content(folder / "glass.png") == content(folder / "solid.png"));
  CHECK(glass["primitives"][0]["pixels"] > 0);
  CHECK(glass["primitives"][1]["pixels"] == 0);
  const nlohmann::json opaque = draw("opaque", "--memory-bits 256 --surface opaque");
  CHECK(opaque["primitives"][0]["pixels"] == 0);
  CHECK(opaque["primitives"][1]["pixels"] > 0);
  CHECK(opaque["primitives"][2]["pixels"] == 0);
  CHECK(content(folder / "opaque.exr") != content(folder / "glass.exr"));
  check_misuse("render " + (folder / "m.csg") + " --surface near", "nearest");

  const std::string program = (folder / "m.csgt");
  require_success(run("compile " + (folder / "m.csg") + from_front + "--memory-bits 256 -o " + program));
  for (const std::string level : {"functional", "reference", "cycle"}) {
    require_success(run("run " + program + " --level " + level + " --depth " + (folder / "run.exr") + " --owner " +
                        (folder / "run.png")));
    CHECK(content(folder / "run.exr") == content(folder / "glass.exr"));
    CHECK(json(folder / "run.json") == glass);
  }
}

TEST_CASE("a resumed run with transparent surfaces gives the same depth and owners") {
  const Folder folder;
  write(folder / "m.csg", panes);
  const std::string program = (folder / "m.csgt");
  require_success(run("compile " + (folder / "m.csg") + from_front + "--memory-bits 256 -o " + program));
  require_success(run("run " + program + " --depth " + (folder / "whole.exr") + " --checkpoint " + (folder / "c.csgs") +
                      " --checkpoint-every 150"));
  const Outcome resumed = require_success(run("run " + program + " --depth " + (folder / "resumed.exr") + " --owner " +
                                              (folder / "resumed.png") + " --resume " + (folder / "c.csgs")));
  CHECK(content(folder / "whole.exr") == content(folder / "resumed.exr"));
}
