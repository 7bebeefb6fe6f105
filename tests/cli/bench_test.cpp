#include <doctest/doctest.h>
#include <stdlib.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

Outcome measure(std::vector<std::string> words) {
  words.insert(words.begin(), "measure");
  return run_program(std::string(CSGSIM_BINARY_DIR) + "/csgsim_bench", words);
}

}  // namespace

TEST_CASE("bench measures in turn, tells what was measured and by which command, and says what is not installed") {
  const Folder folder;
  ::setenv("PATH", folder.path().c_str(), 1);
  const Outcome outcome =
      measure({model("old_example011"), "--size", "32x32", "--rounds", "1", "--parts", "speed,dense,rivals",
               "--machines", "pixel-planes-4,pixel-square", "-o", folder / "b"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  CHECK(outcome.out.find(content(folder / "b/bench.md")) == 0);
  const nlohmann::json bench = json(folder / "b/bench.json");
  CHECK_FALSE(bench["build"]["compiler"].get<std::string>().empty());
  REQUIRE(bench["speed"].size() == 3 * 2 * 2);
  for (const nlohmann::json& row : bench["speed"]) {
    CHECK(row["clocks"] > 0);
    CHECK(row["simulated_over_wall"].get<double>() ==
          doctest::Approx(row["simulated_seconds"].get<double>() / row["wall_seconds"].get<double>()));
    CHECK(row["command"].get<std::string>().starts_with("csgsim run "));
  }
  // Functional and cycle are of one Program.
  CHECK(bench["speed"][0]["clocks"] == bench["speed"][1]["clocks"]);
  REQUIRE(bench["dense"].size() == 3);
  CHECK(bench["dense"][0]["clocks"] == bench["speed"][0]["clocks"]);
  CHECK(bench["dense"][0]["dense_seconds"] > 0);
  REQUIRE(bench["rivals"].size() >= 6);
  for (const nlohmann::json& row : bench["rivals"]) CHECK(row["not_measured"] == "not installed");
  CHECK(bench["growth"].empty());
  const Outcome misused = measure({"--parts", "speeds", "-o", folder / "c"});
  CHECK(misused.code == 2);
  CHECK(one_line(misused.err));
  CHECK(misused.err.find("speed") != std::string::npos);
}

TEST_CASE("bench fits what growth costs, and draws it") {
  const Folder folder;
  const Outcome outcome = measure({"--size", "64x64", "--seconds", "0", "--parts", "growth", "-o", folder / "b"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.code == 0);
  const nlohmann::json growth = json(folder / "b/bench.json")["growth"];
  REQUIRE(growth.size() == 6);
  for (const nlohmann::json& row : growth) {
    CHECK(row["points"].size() >= 2);
    CHECK((row.contains("exponent") && row["exponent"].is_number()) == (row["points"].size() >= 3));
    const std::string plot = "b/growth_" + row["against"].get<std::string>();
    CHECK(fs::file_size(folder / (plot + ".png")) > 1000);
    CHECK(fs::file_size(folder / (plot + ".svg")) > 1000);
  }
}
