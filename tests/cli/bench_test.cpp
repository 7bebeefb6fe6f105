#include <stdlib.h>

#include "places.h"
#include "tests/cli/cli.h"

using namespace csgsim::testing::cli;

namespace {

const std::string binary_folder = CSGSIM_BINARY_DIR;

Outcome bench(const std::vector<std::string>& words) { return run_program(binary_folder + "/csgsim_bench", words); }

Outcome measure(std::vector<std::string> words) {
  words.insert(words.begin(), "measure");
  return bench(words);
}

}  // namespace

TEST_CASE("bench reports each measurement with its command and names missing programs") {
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
  // The functional and the cycle level run the same Program.
  CHECK(bench["speed"][0]["clocks"] == bench["speed"][1]["clocks"]);
  REQUIRE(bench["dense"].size() == 3);
  CHECK(bench["dense"][0]["clocks"] == bench["speed"][0]["clocks"]);
  CHECK(bench["dense"][0]["dense_seconds"] > 0);
  REQUIRE(bench["rivals"].size() >= 6);
  for (const nlohmann::json& row : bench["rivals"]) CHECK(row["not_measured"] == "not installed");
  CHECK(bench["growth"].empty());
  fails(measure({"--parts", "speeds", "-o", folder / "c"}), 2, {"speed"});
}

TEST_CASE("bench measures another build alongside this one and reports the ratio") {
  const Folder folder;
  ::setenv("PATH", folder.path().c_str(), 1);
  const Outcome outcome = require_success(measure(
      {"--size", "32x32", "--rounds", "1", "--parts", "speed,counts,schedule,works", "--works", "picture", "--machines",
       "pixel-square", "--levels", "functional", "--beside", binary_folder + "/csgsim", "-o", folder / "b"}));
  CHECK(outcome.out.find("other ÷ this") != std::string::npos);
  const nlohmann::json bench = json(folder / "b/bench.json");
  REQUIRE(bench["speed"].size() == 2);
  REQUIRE(bench["works"].size() == 1);
  for (const nlohmann::json& row : {bench["speed"][0], bench["speed"][1], bench["works"][0]}) {
    // The median ratio of one round is the ratio of its two times.
    CHECK(row["other_over_this"].get<double>() ==
          doctest::Approx(row["other_wall_seconds"].get<double>() / row["wall_seconds"].get<double>()));
  }
  CHECK(bench["works"][0]["memory_bytes"] > 1e6);
  CHECK(bench["works"][0]["other_memory_bytes"] > 1e6);
  REQUIRE(bench["counts"].size() == 2);
  for (const nlohmann::json& row : bench["counts"]) {
    CHECK(row["instructions"] > 0);
    CHECK(row["not_counted"] == "valgrind: not installed");
  }
  REQUIRE(bench["schedule"].size() == 2);
  for (const nlohmann::json& row : bench["schedule"]) {
    CHECK(row["tiles"].size() == row["segments"].size());
    CHECK(row["segments"].back()["seconds"] < row["segments"].front()["seconds"]);
  }
}

TEST_CASE("bench counts the work of a Program reproducibly") {
  const std::string program = std::string(CSGSIM_SOURCE_DIR) + "/traces/thesis_fig_2_3_squares.csgt";
  const Outcome outcome = require_success(bench({"count", program}));
  CHECK(outcome.out.starts_with("segments "));
  CHECK(bench({"count", program}).out == outcome.out);
  const nlohmann::json counts = nlohmann::json::parse(bench({"count", "--json", program}).out);
  CHECK(outcome.out.find("\nlongest " + counts["longest"].dump() + "\n") != std::string::npos);
  CHECK(bench({"count", std::string(CSGSIM_SOURCE_DIR) + "/README.md"}).code == 1);
}

TEST_CASE("bench fits a power law to the time of growing models and plots it") {
  const Folder folder;
  require_success(measure({"--size", "64x64", "--seconds", "0", "--parts", "growth", "-o", folder / "b"}));
  const nlohmann::json growth = json(folder / "b/bench.json")["growth"];
  REQUIRE(growth.size() == 7);
  for (const nlohmann::json& row : growth) {
    CHECK(row["points"].size() >= 2);
    CHECK((row.contains("exponent") && row["exponent"].is_number()) == (row["points"].size() >= 3));
    const std::string plot = "b/growth_" + row["against"].get<std::string>();
    CHECK(fs::file_size(folder / (plot + ".png")) > 1000);
    CHECK(fs::file_size(folder / (plot + ".svg")) > 1000);
  }
}
