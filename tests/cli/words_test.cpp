#include <algorithm>
#include <sstream>
#include <tuple>

#include "hw/base/text.h"
#include "hw/kinds/load.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

/// The first words of the lines of a summary, those of their first column.
std::vector<std::string> labels_of(const std::string& text) {
  std::vector<std::string> labels;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) labels.push_back(line.substr(0, line.find(' ')));
  return labels;
}

/// The line that begins with the label; empty if there is none.
std::string line_of(const std::string& text, const std::string& label) {
  const std::size_t at = ("\n" + text).find("\n" + label + " ");
  return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

}  // namespace

TEST_CASE("render and run print at most 12 lines in a fixed order on every machine") {
  for (const std::string_view machine : csgsim::kinds::built_in_names()) {
    CAPTURE(machine);
    const Folder folder;
    const std::string of = model("thesis_fig_2_3") + fmt::format(" --size 48x48 --machine {} ", machine);
    const Outcome drawn =
        require_success(run("render " + of + "-o " + (folder / "p.png") + " --stats " + (folder / "s.json")));
    const nlohmann::json stats = json(folder / "s.json");
    std::vector<std::string> labels{"picture", "model", "machine", "drawn", "shown", "host", "memory", "advice"};
    if (!stats["machine"]["ideal"].empty()) labels.insert(labels.begin() + 3, "ideal");
    CHECK(labels_of(drawn.out) == labels);
    CHECK(labels.size() <= 12);
    CHECK(drawn.err == "");
    CHECK(has(line_of(drawn.out, "picture"), "written to " + (folder / "p.png")));
    CHECK(has(line_of(drawn.out, "drawn"), "(" + csgsim::grouped(stats["clocks"]) + " clocks)"));
    CHECK(has(line_of(drawn.out, "shown"), "limited by"));
    CHECK(has(line_of(drawn.out, "shown"), stats["bound_by"]["part"].get<std::string>()));
    CHECK(has(line_of(drawn.out, "host"), "which limits the rate") == stats["bound_by"]["by_host"].get<bool>());
    require_success(run("compile " + of + "-o " + (folder / "p.csgt")));
    const Outcome again = require_success(run("run " + (folder / "p.csgt")));
    CHECK(labels_of(again.out) == labels);
    CHECK(has(line_of(again.out, "picture"), "not written; add -o picture.png"));
    for (const char* const label : {"model", "machine", "drawn", "shown", "host", "memory"})
      CHECK(line_of(again.out, label) == line_of(drawn.out, label));
  }
}

TEST_CASE("the verdict and advice and idealizations stay within 12 lines") {
  const Outcome outcome = require_success(
      run("render " + model("thesis_fig_2_3") +
          " --size 48x48 --check --advice --machine pixel-planes-4+link.width=ideal+memory.clear_clocks=ideal"));
  const std::vector<std::string> labels = labels_of(outcome.out);
  CHECK(labels.size() <= 12);
  CHECK(std::vector(labels.begin(), labels.begin() + 10) == std::vector<std::string>{"picture", "model", "machine",
                                                                                     "ideal", "drawn", "shown", "host",
                                                                                     "memory", "accuracy", "advice"});
}

TEST_CASE("--verbose adds the counts and the costliest primitives and all advice") {
  const Folder folder;
  const std::string words = "render " + model("carburettor") + " --size 64x64 --advice --stats " + (folder / "s.json");
  const Outcome brief = require_success(run(words));
  const Outcome outcome = require_success(run(words + " --verbose"));
  const nlohmann::json stats = json(folder / "s.json");
  CHECK(labels_of(brief.out).size() <= 12);
  CHECK(outcome.out.starts_with(brief.out.substr(0, brief.out.find("advice"))));
  CHECK(stats["bound_by"]["part"] == "array");
  REQUIRE(stats["dearest"].size() == 10);
  const nlohmann::json& costliest = stats["dearest"][0];
  const nlohmann::json& counted = stats["by_primitive"][costliest["primitive"].get<std::size_t>()];
  CHECK(costliest["name"] == counted["name"]);
  CHECK(costliest["clocks"] == counted["clocks"]);
  CHECK(costliest["pieces"] == counted["pieces"]);
  CHECK(has(outcome.out, "12 other primitives"));
  CHECK(has(outcome.out, "simulated in"));
  REQUIRE(stats["knobs"].size() > 2);
  for (const nlohmann::json& knob : stats["knobs"]) {
    CHECK(has(outcome.out, knob["option"].get<std::string>() + ": " + knob["worth"].get<std::string>()));
  }
  const nlohmann::json& best = stats["knobs"][0];
  CHECK(has(line_of(brief.out, "advice"), best["option"].get<std::string>() + ": " + best["worth"].get<std::string>()));
}

TEST_CASE("the advice offers the best pruning and its gain for the frame with the host") {
  const Folder folder;
  const Outcome outcome = require_success(
      run("render " + model("carburettor") + " --size 64x64 --pruning all --advice --stats " + (folder / "s.json")));
  const nlohmann::json stats = json(folder / "s.json");
  REQUIRE(stats["bound_by"]["by_host"] == true);
  const auto pruning = std::ranges::find_if(stats["knobs"], [](const nlohmann::json& knob) {
    return knob["option"].get<std::string>().starts_with("--pruning ");
  });
  REQUIRE(pruning != stats["knobs"].end());
  CHECK((*pruning)["hosted_clocks_after"] < (*pruning)["hosted_clocks_before"]);
  CHECK(has((*pruning)["worth"], "per frame with the host instead of"));
  CHECK(has(outcome.out, (*pruning)["option"].get<std::string>() + ": " + (*pruning)["worth"].get<std::string>()));
  const auto tries = [&](const std::string& key) {
    return std::ranges::any_of(stats["knobs"],
                               [&](const nlohmann::json& knob) { return has(knob["option"].get<std::string>(), key); });
  };
  CHECK(tries("host.processor="));
  CHECK(tries("host.count=2"));
}

TEST_CASE("render measures advice only on request and its summary names the option") {
  const Folder folder;
  const Outcome outcome = run("render " + model("thesis_fig_2_3") + " --size 48x48 --stats " + (folder / "s.json"));
  CHECK(json(folder / "s.json")["knobs"].empty());
  CHECK(has(line_of(outcome.out, "advice"), "--advice"));
}

TEST_CASE("the saving that advice states for an option equals that of render with it") {
  for (const std::string machine : {"pixel-planes-4", "pixel-square"}) {
    CAPTURE(machine);
    const Folder folder;
    const std::string words =
        "render " + model("thesis_fig_2_3") + " --size 64x64 --stats " + (folder / "s.json") + " ";
    const std::string given = "--machine " + machine;
    require_success(run(words + given + " --advice"));
    const nlohmann::json knobs = json(folder / "s.json")["knobs"];
    REQUIRE(knobs.size() > 2);
    bool sets = false;
    for (const nlohmann::json& knob : knobs) {
      const std::string option = knob["option"];
      CAPTURE(option);
      const bool is_machine = option.starts_with("--machine");
      sets = sets || !is_machine;
      require_success(run(words + (is_machine ? option : given + " " + option)));
      const nlohmann::json stats = json(folder / "s.json");
      CHECK(stats["interval_clocks"] == knob["clocks_after"]);
      CHECK(std::max(stats["interval_clocks"], stats["host_clocks"]) == knob["hosted_clocks_after"]);
      CHECK(std::tie(knob["hosted_clocks_after"], knob["clocks_after"]) <
            std::tie(knob["hosted_clocks_before"], knob["clocks_before"]));
    }
    CHECK(sets);
  }
}

TEST_CASE("render's summary lists the clocks of effects apart from those of primitives") {
  const Folder folder;
  const Outcome outcome =
      run("render " + model("thesis_fig_2_3") +
          " --size 48x48 --memory-bits 128 --set effects.shadows.on=true --verbose --stats " + (folder / "s.json"));
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
  check_misuse("render " + model("old_example011") + " --frames 2 -o x.png --advice", "--advice");
}

TEST_CASE("compare ends with the bottleneck and costliest primitives of each machine") {
  const Folder folder;
  const Outcome outcome =
      run("compare " + model("thesis_fig_2_3") +
          " --machines pixel-planes-4,scan-line --size 64x64 --sides 32 --fragments 8 --no-plots -o " + (folder / "c"));
  REQUIRE(outcome.code == 0);
  require_success(
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
  require_success(run("render " + model("thesis_fig_2_3") + " --machine pixel-planes-4 --size 64x64 --stats " +
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
