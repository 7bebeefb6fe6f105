#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

TEST_CASE("render and its stats end with the bottleneck and costliest primitives and advice") {
  const Folder folder;
  const std::string words = "render " + model("carburettor") + " --size 64x64 --advice --stats " + (folder / "s.json");
  const Outcome outcome = succeeded(run(words));
  const nlohmann::json stats = json(folder / "s.json");
  CHECK(stats["bound_by"]["part"] == "array");
  CHECK(outcome.out.find(stats["bound_by"]["sentence"].get<std::string>()) != std::string::npos);
  REQUIRE(stats["dearest"].size() == 10);
  const nlohmann::json& costliest = stats["dearest"][0];
  const nlohmann::json& counted = stats["by_primitive"][costliest["primitive"].get<std::size_t>()];
  CHECK(costliest["name"] == counted["name"]);
  CHECK(costliest["clocks"] == counted["clocks"]);
  CHECK(costliest["pieces"] == counted["pieces"]);
  CHECK(outcome.out.find("12 other primitives") != std::string::npos);
  REQUIRE(!stats["knobs"].empty());
  CHECK(outcome.out.find(stats["knobs"][0]["sentence"].get<std::string>()) != std::string::npos);
  CHECK(outcome.out.find(stats["knobs"][0]["option"].get<std::string>()) != std::string::npos);
}

TEST_CASE("render measures advice only on request and its summary names the option") {
  const Folder folder;
  const Outcome outcome = run("render " + model("thesis_fig_2_3") + " --size 48x48 --stats " + (folder / "s.json"));
  CHECK(json(folder / "s.json")["knobs"].empty());
  CHECK(outcome.out.find("--advice") != std::string::npos);
}

TEST_CASE("the saving that advice states for an option equals that of render with it") {
  for (const std::string machine : {"pixel-planes-4", "pixel-square"}) {
    CAPTURE(machine);
    const Folder folder;
    const std::string words =
        "render " + model("thesis_fig_2_3") + " --size 64x64 --stats " + (folder / "s.json") + " ";
    const std::string given = "--machine " + machine;
    succeeded(run(words + given + " --advice"));
    const nlohmann::json knobs = json(folder / "s.json")["knobs"];
    REQUIRE(knobs.size() > 2);
    bool sets = false;
    for (const nlohmann::json& knob : knobs) {
      const std::string option = knob["option"];
      CAPTURE(option);
      const bool is_machine = option.starts_with("--machine");
      sets = sets || !is_machine;
      succeeded(run(words + (is_machine ? option : given + " " + option)));
      CHECK(json(folder / "s.json")["interval_clocks"] == knob["clocks_after"]);
      CHECK(knob["clocks_after"] < knob["clocks_before"]);
    }
    CHECK(sets);
  }
}

TEST_CASE("render's summary lists the clocks of effects apart from those of primitives") {
  const Folder folder;
  const Outcome outcome =
      run("render " + model("thesis_fig_2_3") +
          " --size 48x48 --memory-bits 128 --set effects.shadows.on=true --stats " + (folder / "s.json"));
  REQUIRE(outcome.code == 0);
  const nlohmann::json stats = json(folder / "s.json");
  CHECK(stats["by_effect"]["shadows"]["clocks"] > 0);
  CHECK(outcome.out.find("effect shadows") != std::string::npos);
  std::uint64_t plain = 0;
  for (const nlohmann::json& one : stats["dearest"]) plain += one["clocks"].get<std::uint64_t>();
  std::uint64_t with_effects = 0;
  for (const nlohmann::json& one : stats["by_primitive"]) with_effects += one["clocks"].get<std::uint64_t>();
  CHECK(plain < with_effects);
  std::uint64_t all = 0;
  for (const auto& [name, cost] : stats["instructions"]["by_name"].items()) all += cost["clocks"].get<std::uint64_t>();
  CHECK(plain + stats["by_effect"]["shadows"]["clocks"].get<std::uint64_t>() <= all);
}

TEST_CASE("rejects --advice for a sequence of frames") {
  misused("render " + model("old_example011") + " --frames 2 -o x.png --advice", "--advice");
}

TEST_CASE("compare ends with the bottleneck and costliest primitives of each machine") {
  const Folder folder;
  const Outcome outcome =
      run("compare " + model("thesis_fig_2_3") +
          " --machines pixel-planes-4,scan-line --size 64x64 --sides 32 --fragments 8 --no-plots -o " + (folder / "c"));
  REQUIRE(outcome.code == 0);
  succeeded(
      run("render " + model("thesis_fig_2_3") + " --machine scan-line --size 64x64 --stats " + (folder / "s.json")));
  const nlohmann::json points = json(folder / "c/compare.json")["points"];
  const nlohmann::json stats = json(folder / "s.json");
  for (const nlohmann::json& point : points) {
    if (point["machine"] != "scan-line" || point["width"] != 64 || point["fragments"] != 0) continue;
    CHECK(point["bound_by"] == stats["bound_by"]["part"]);
    CHECK(point["bound_share"] == stats["bound_by"]["share"]);
    REQUIRE(point["dearest"].size() == stats["dearest"].size());
    CHECK(point["dearest"][0]["name"] == stats["dearest"][0]["name"]);
    CHECK(point["dearest"][0]["clocks"] == stats["dearest"][0]["clocks"]);
  }
  CHECK(outcome.out.find("limited by") != std::string::npos);
  CHECK(outcome.out.find(stats["dearest"][0]["name"].get<std::string>()) != std::string::npos);
  CHECK(outcome.out.find("$fn = 8 gives") != std::string::npos);
  // The share of the first machine's most expensive primitive on each machine, as render reports it.
  succeeded(run("render " + model("thesis_fig_2_3") + " --machine pixel-planes-4 --size 64x64 --stats " +
                (folder / "p.json")));
  const nlohmann::json first = json(folder / "p.json")["dearest"];
  const std::string name = first[0]["name"];
  const std::size_t line = outcome.out.find("\n  " + name + " ", outcome.out.find("most expensive primitives"));
  REQUIRE(line != std::string::npos);
  const std::string shares = outcome.out.substr(line + 1, outcome.out.find('\n', line + 1) - line - 1);
  CAPTURE(shares);
  for (const nlohmann::json& costliest : {first, stats["dearest"]}) {
    for (const nlohmann::json& one : costliest) {
      if (one["name"] != name) continue;
      CHECK(shares.find(fmt::format(" {:.1f} %", 100.0 * one["share"].get<double>())) != std::string::npos);
    }
  }
}
