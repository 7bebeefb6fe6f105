#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string tiny_figure = model("thesis_fig_2_3") + " --size 16x16 --progress none --no-plots";
const std::string tree_designs =
    " --vary evaluator.bits=1,2 --vary alu.bits=2 --process nmos-3um --sensitivity --samples 3";

/// A table without every third row.
void drop_rows(const std::string& table) {
  std::istringstream lines(content(table));
  std::string rest;
  std::string line;
  for (unsigned i = 0; std::getline(lines, line); ++i) {
    if (i % 3 != 2) rest += line + "\n";
  }
  std::ofstream(table) << rest;
}

nlohmann::json point_with(const nlohmann::json& points, const nlohmann::json& figures) {
  for (const nlohmann::json& point : points) {
    if (point["figures"] == figures && point["design"]["evaluator.bits"] == 2) return point;
  }
  FAIL("no point has these figures");
  return {};
}

}  // namespace

TEST_CASE("variants of explore --sensitivity equal single runs of explore and render") {
  const Folder folder;
  const Outcome outcome = require_success(run("explore " + tiny_figure + tree_designs + " -o " + (folder / "e")));
  const nlohmann::json file = json(folder / "e/explore.json");
  const nlohmann::json& sensitivity = file["sensitivity"];
  CHECK(file["points"].size() == 2 * sensitivity["variants"].get<std::size_t>());
  CHECK(sensitivity["samples"] == 3);
  CHECK(file["fronts"][0]["designs"] == 2);
  CHECK(outcome.out.find("evaluator.bits=2 against evaluator.bits=1") != std::string::npos);
  CHECK(outcome.out.find("change nothing") != std::string::npos);

  using Json = nlohmann::json;
  for (const Json& figures : {Json{{"link.width", 16}}, Json{{"gate.delay", 2000}}, Json{{"memory.reads", 2}}}) {
    const Json point = point_with(file["points"], figures);
    require_success(run("explore " + tiny_figure + " --machine " + point["machine"].get<std::string>() + " --process " +
                        point["process"].get<std::string>() + " --vary z-bits=" + point["z_bits"].dump() + " -o " +
                        (folder / figures.begin().key())));
    const Json alone = json(folder / figures.begin().key() + "/explore.json")["points"][0];
    for (const char* const key : {"clocks", "clock_hz", "frames_per_second", "machine_mm2", "frame_joules", "wrong"})
      CHECK(point[key] == alone[key]);
    require_success(run("render " + model("thesis_fig_2_3") + " --size 16x16 --machine " +
                        point["machine"].get<std::string>() + " --memory-bits " + point["used_bits"].dump() +
                        " --stats " + (folder / "s.json")));
    CHECK(json(folder / "s.json")["clocks"] == point["clocks"]);
  }
}

TEST_CASE("explore --sensitivity has equal results if it is resumed or sharded") {
  const Folder folder;
  const std::string command = "explore " + tiny_figure + tree_designs;
  const Outcome whole = require_success(run(command + " -o " + (folder / "e")));
  const std::string table = content(folder / "e/explore.csv");
  const std::string file = content(folder / "e/explore.json");
  drop_rows(folder / "e/explore.csv");
  CHECK(require_success(run(command + " --threads 2 -o " + (folder / "e"))).out == whole.out);
  CHECK(content(folder / "e/explore.csv") == table);
  CHECK(content(folder / "e/explore.json") == file);

  for (const char* const shard : {"1/2", "2/2"})
    require_success(run(command + " --shard " + shard + " -o " + (folder / "s")));
  require_success(run("gather --no-plots --report " + (folder / "p.html") + " " + (folder / "s")));
  CHECK(content(folder / "s/explore.csv") == table);
  CHECK(content(folder / "s/explore.json") == file);
  CHECK(content(folder / "p.html").find("figures that change the sign") != std::string::npos);
}

TEST_CASE("explore --sensitivity draws tornados of each metric and of the ratios") {
  const Folder folder;
  require_success(run("explore " + model("thesis_fig_2_3") + " --size 16x16 --progress none --axes time" +
                      tree_designs + " -o " + (folder / "e")));
  for (const char* const plot : {"tornado_time_1", "tornado_time_2", "tornado_time_2_against_1"}) {
    for (const char* const ending : {".png", ".svg"})
      CHECK(fs::file_size(folder.path() / "e" / (std::string(plot) + ending)) > 1000);
  }
}
