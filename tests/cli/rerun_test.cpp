#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

nlohmann::json counts(const std::string& path) {
  nlohmann::json stats = json(path);
  stats.erase("wall_seconds");
  stats.erase("configuration");
  return stats;
}

/// Runs the words with a picture and stats, then repeats the run from the stats: both files must be identical.
void runs_again(const Folder& folder, std::vector<std::string> words) {
  words.insert(words.end(), {"-o", "a.png", "--depth", "a.exr", "--stats", "a.json"});
  require_success(run_words(words, folder.path()));
  const std::string stats = content(folder / "a.json");
  const Outcome again =
      run_words({"rerun", "a.json", "-o", "b.png", "--depth", "b.exr", "--stats", "b.json"}, folder.path());
  CAPTURE(again.err);
  REQUIRE(again.code == 0);
  CHECK(again.out.find("the picture and all counts equal those of a.json") != std::string::npos);
  CHECK(content(folder / "a.json") == stats);
  CHECK(content(folder / "b.png") == content(folder / "a.png"));
  CHECK(content(folder / "b.exr") == content(folder / "a.exr"));
  CHECK(counts(folder / "b.json") == counts(folder / "a.json"));
  // The repeated run records the same configuration, so it can be repeated in turn.
  const nlohmann::json one = json(folder / "a.json")["configuration"];
  const nlohmann::json other = json(folder / "b.json")["configuration"];
  for (const std::string key : {"machine", "camera", "model", "inputs", "picture", "version"})
    CHECK(one[key] == other[key]);
  require_success(run_words({"rerun", "b.json"}, folder.path()));
}

void refused(const Outcome& outcome, const std::string& message) { fails(outcome, 1, {message}); }

/// Writes a model that imports a mesh of that height.
void write_imported(const Folder& folder, int height) {
  write(folder / "m.csg",
        "import(file = \"part.off\", layer = \"\", origin = [0, 0], scale = 1, convexity = 1, $fn = 0, $fa = 12, $fs = "
        "2);\n");
  write(folder / "part.off",
        fmt::format("OFF\n4 4 0\n0 0 0\n9 0 0\n0 9 0\n0 0 {}\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n", height));
}

}  // namespace

TEST_CASE("rerun repeats a render byte for byte on every kind of machine") {
  const Folder folder;
  for (const std::string machine :
       {"pixel-planes-4", "scan-line", "pixel-square", "pixel-planes-5", "multi-processor"}) {
    CAPTURE(machine);
    runs_again(folder, {"render", model("old_example002"), "--machine", machine, "--size", "48x40"});
  }
}

TEST_CASE("rerun repeats a render whose options come from several sources") {
  const Folder folder;
  write(folder / "look.toml", "[ambient]\nintensity = 0.6\n[[lights]]\ndirection = [0, 1, -1]\n");
  write(folder / "s.toml",
        "strategy = 'list'\npruning = 'no-hidden+no-sets'\n[render]\nset = ['alu.bits=2', 'ambient.intensity=0.5']\n");
  fs::copy(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml", folder / "mine.toml");
  runs_again(folder, {"render",       model("thesis_fig_2_3"),
                      "--size",       "40x30",
                      "--machine",    "mine.toml",
                      "--scene",      "look.toml",
                      "--config",     "s.toml",
                      "--projection", "perspective",
                      "--check",      "--snap",
                      "--tolerance",  "0.5px",
                      "--near",       "1.25",
                      "--edge-on",    "0.0123456789"});
  const nlohmann::json configuration = json(folder / "a.json")["configuration"];
  CHECK(configuration["options"]["edge-on"] == 0.0123456789);
  CHECK(configuration["options"]["strategy"] == "list");
  CHECK(configuration["scene"]["ambient"]["intensity"] == 0.5);
  CHECK(configuration["scene"]["lights"][0]["direction"] == nlohmann::json({0, 1, -1}));
  CHECK(configuration["machine"]["name"] == "pixel-planes-4+alu.bits=2");
  CHECK(configuration["machine"]["figures"]["alu.bits"]["value"] == 2);
  CHECK(configuration["machine"]["figures"]["alu.bits"]["provenance"] == "assumed");
  CHECK(configuration["machine"]["figures"]["array.width"]["value"] == 40);
  CHECK(configuration["camera"]["projection"] == "perspective");
  CHECK(configuration["camera"]["near"] == 1.25);
  // The options include the settings, so their file is no longer needed.
  fs::remove(folder / "s.toml");
  require_success(run_words({"rerun", "a.json"}, folder.path()));
}

TEST_CASE("rerun repeats the settings that render chose for a wrong-pixel limit") {
  const Folder folder;
  runs_again(folder, {"render", model("thesis_fig_2_3"), "--size", "24x24", "--max-wrong-pixels", "40"});
}

TEST_CASE("rerun repeats the run of a Program and one resumed from a checkpoint") {
  const Folder folder;
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/old_example002_lines.csgt";
  runs_again(folder, {"run", program, "--machine", "scan-line", "--set", "cells.words=6"});
  runs_again(folder, {"run", program, "--machine", "scan-line", "--checkpoint", "c.csgs", "--checkpoint-every", "200"});
  fs::remove(folder / "c.csgs");
  require_success(run_words({"rerun", "a.json"}, folder.path()));
  CHECK(!fs::exists(folder / "c.csgs"));
}

TEST_CASE("rerun repeats a run of the cycle level at the cycle level") {
  const Folder folder;
  runs_again(folder, {"render", model("thesis_fig_2_3"), "--size", "24x24", "--level", "cycle"});
  CHECK(json(folder / "b.json")["level"] == "cycle");
  runs_again(folder,
             {"render", model("thesis_fig_2_3"), "--size", "24x24", "--level", "cycle", "--evaluator", "stepped"});
  CHECK(json(folder / "b.json")["configuration"]["options"]["evaluator"] == "stepped");
}

TEST_CASE("rerun resolves relative names in the folder of the original run") {
  const Folder folder;
  fs::create_directory(folder / "there");
  fs::create_directory(folder / "here");
  fs::copy(model("old_example002"), folder / "there/m.csg");
  REQUIRE(
      run_words({"render", "m.csg", "--size", "16x16", "-o", "a.png", "--stats", "a.json"}, folder / "there").code ==
      0);
  refused(run_words({"rerun", "../there/a.json"}, folder / "here"), "m.csg: cannot be read");
  require_success(run_words({"rerun", "../there/a.json", "--from", "../there", "-o", "b.png"}, folder / "here"));
  CHECK(content(folder / "here/b.png") == content(folder / "there/a.png"));
}

TEST_CASE("rerun detects a changed input before it runs or writes") {
  const Folder folder;
  write_imported(folder, 9);
  write(folder / "look.toml", "[ambient]\nintensity = 0.6\n");
  fs::copy(std::string(CSGSIM_SOURCE_DIR) + "/hw/machines/pixel-planes-4.toml", folder / "mine.toml");
  require_success(run_words(
      {"render", "m.csg", "--size", "16x16", "--scene", "look.toml", "--machine", "mine.toml", "--stats", "a.json"},
      folder.path()));
  for (const std::string name : {"m.csg", "part.off", "look.toml", "mine.toml"}) {
    const std::string before = content(folder / name);
    write(folder / name, before + "\n");
    refused(run_words({"rerun", "a.json", "-o", "b.png"}, folder.path()),
            "a.json: " + name + " has changed; add --anyway to continue");
    CHECK(!fs::exists(folder / "b.png"));
    // The change does not affect the picture.
    const Outcome anyway = run_words({"rerun", "a.json", "--anyway"}, folder.path());
    CHECK(anyway.err.find(name + " has changed") != std::string::npos);
    CHECK(anyway.code == 0);
    write(folder / name, before);
  }
  write_imported(folder, 5);
  const Outcome other = run_words({"rerun", "a.json", "--anyway", "-o", "b.png"}, folder.path());
  CHECK(other.code == 1);
  CHECK(other.err.find("a.json: the run differs: the picture; ") != std::string::npos);
  CHECK(fs::exists(folder / "b.png"));
}

TEST_CASE("rerun detects a change in a file that OpenSCAD source includes") {
  const Folder folder;
  write_stand_in(folder, "openscad", "cat part.scad");
  write(folder / "m.scad", "include <part.scad>\n");
  write(folder / "part.scad", "cube(size = [9, 9, 9]);\n");
  require_success(run_with_stand_ins(folder, {"render", "m.scad", "--size", "16x16", "--stats", "a.json"}));
  require_success(run_with_stand_ins(folder, {"rerun", "a.json"}));
  write(folder / "part.scad", "cube(size = [8, 8, 8]);\n");
  refused(run_with_stand_ins(folder, {"rerun", "a.json", "-o", "b.png"}),
          "a.json: m.scad, or a file that it includes, has changed; add --anyway to continue");
  CHECK(!fs::exists(folder / "b.png"));
}

TEST_CASE("rerun reports another version and each differing count with both values") {
  const Folder folder;
  require_success(run("render " + model("old_example002") + " --size 16x16 --stats " + (folder / "a.json")));
  nlohmann::ordered_json stats = nlohmann::ordered_json::parse(content(folder / "a.json"));
  const std::uint64_t clocks = stats["clocks"];
  stats["configuration"]["version"] = "0.0.1 of yore";
  stats["clocks"] = clocks + 1;
  write(folder / "b.json", stats.dump());
  refused(run_words({"rerun", "b.json"}, folder.path()),
          "b.json: it was written by csgsim 0.0.1 of yore, and this is 0.");
  const Outcome anyway = run_words({"rerun", "b.json", "--anyway"}, folder.path());
  CHECK(anyway.code == 1);
  CHECK(anyway.err.find(fmt::format("b.json: the run differs: /clocks was {}, is {}", clocks + 1, clocks)) !=
        std::string::npos);
}

TEST_CASE("rerun rejects a file that is not a stats file with the place of the error") {
  const Folder folder;
  write(folder / "a.json", "{\n  \"clocks\": 3,\n}");
  refused(run_words({"rerun", "a.json"}, folder.path()), "a.json:3:1: not valid JSON");
  write(folder / "a.json", "{\"configuration\": " + std::string(1'000'000, '[') + std::string(1'000'000, ']') + "}");
  refused(run_words({"rerun", "a.json"}, folder.path()), "a.json: brackets are nested deeper than");
  write(folder / "a.json", "{\"clocks\": 3}");
  refused(run_words({"rerun", "a.json"}, folder.path()), "a.json: it has no configuration");
  write(folder / "a.json", R"({"configuration": {"command": ["csgsim", "sweep"], "options": {}}})");
  refused(run_words({"rerun", "a.json"}, folder.path()), "only runs of render and run can be repeated");
  write(folder / "a.json", R"({"configuration": {"command": ["csgsim", "run"], "options": {"program": 7}}})");
  refused(run_words({"rerun", "a.json"}, folder.path()), "its configuration has 7 where a string should be");
  write(folder / "a.json", R"({"configuration": {"command": ["csgsim", "run"], "options": {"program": "p", "-": 7}}})");
  CHECK(run_words({"rerun", "a.json"}, folder.path()).code == 1);
  require_success(run("render " + model("old_example002") + " --size 16x16 --stats " + (folder / "a.json")));
  CHECK(run_words({"rerun", "a.json", "--stats", "a.json"}, folder.path()).code == 2);
}
