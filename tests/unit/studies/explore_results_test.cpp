// Tests of the explore study with made-up rows: results, and rows that it rejects.

#include <doctest/doctest.h>

#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "hw/process/process.h"
#include "sim/report/page.h"
#include "sim/session/options/usage.h"
#include "sim/studies/explore/options.h"
#include "tests/support/error_of.h"
#include "tests/unit/studies/explored.h"

using namespace csgsim;
using studies::ExploreRow;
using testing::Explored;
using testing::Models;
using testing::Texts;
using Json = nlohmann::ordered_json;

namespace {

/// A row as in explore.csv.
ExploreRow made_row(const std::string& model, const std::string& machine, double fps, std::uint32_t used_bits) {
  ExploreRow one;
  one.point.model = model;
  one.point.machine = machine;
  one.point.width = 8;
  one.point.height = 6;
  one.point.z_bits = 20;
  one.point.fraction_bits = 12;
  one.point.colour_bits = 24;
  one.point.pruning = "auto";
  one.point.colouring = "rebroadcast";
  one.point.strategy = "stack";
  one.point.curves = "auto";
  one.inputs = {"h", "m", "v"};
  one.frames_per_second = fps;
  one.used_bits = used_bits;
  one.machine_memory_bits = used_bits;
  one.machine_transistors = 100;
  return one;
}

Texts lines_of(const std::vector<ExploreRow>& rows) {
  Texts lines;
  for (const ExploreRow& row : rows) lines.push_back(studies::to_line(row));
  return lines;
}

/// Returns the study's error for these rows.
std::string refusal_of(const std::vector<ExploreRow>& rows, bool are_read = false) {
  const Explored explored({"m.csg", "n.csg", "--vary", "z-bits=20"});
  explored.study().set_rows(lines_of(rows), are_read);
  return testing::error_of([&] { explored.study().refuse(); });
}

std::string usage_error(const Texts& words) {
  try {
    Explored explored(words);
    explored.ask();
  } catch (const session::UsageError& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("explore rejects rows without drawings or with unexplained wrong pixels") {
  std::vector<ExploreRow> rows{made_row("m.csg", "a", 10, 60), made_row("m.csg", "b", 10, 60)};
  CHECK(refusal_of(rows) == "");
  rows[0].reason = "no memory";
  CHECK(refusal_of(rows) == "");
  rows[1].reason = "nothing at all";
  CHECK(refusal_of(rows) == "no memory");
  rows[1].reason.clear();
  rows[1].wrong = 7;
  CHECK(refusal_of(rows) == "");
  rows[1].unexplained = 1;
  const std::string fault = "the errors of a picture exceed the bounds of docs/numbers.md";
  CHECK_THROWS_WITH_AS(refusal_of(rows), fault.c_str(), std::logic_error);
  CHECK(refusal_of(rows, true).starts_with(fault + "; "));
  // The error names each model that no design draws, whether one or both.
  rows = {made_row("m.csg", "a", 10, 60), made_row("n.csg", "a", 10, 60)};
  rows[1].reason = "no";
  CHECK(refusal_of(rows).find("n.csg") != std::string::npos);
  CHECK(refusal_of(rows).find("explore.csv") != std::string::npos);
  rows[0].reason = "nor this";
  CHECK(refusal_of(rows).find("explore.csv") != std::string::npos);
}

TEST_CASE("the knee's commands draw it on each model with all non-default options") {
  const Explored explored({"m.csg", "a b.csg", "--vary", "z-bits=20", "--camera", "1,2,3,0,0,0", "--view-all", "--set",
                           "background.colour=0,0,1", "--set", "alu.bits=2"});
  // Model m has the memory that its Program takes, the other model the given memory.
  std::vector<ExploreRow> rows{made_row("m.csg", "pixel-planes-4+alu.bits=2", 10, 60),
                               made_row("a b.csg", "pixel-planes-4+alu.bits=2", 10, 70)};
  const auto commands = [&](std::size_t group) {
    explored.study().set_rows(lines_of(rows), false);
    const Json file = Json::parse(explored.study().json("t"));
    return file["fronts"][group]["knee"]["commands"].get<Texts>();
  };
  const auto draw = [](const std::string& model, const std::string& memory, const std::string& more,
                       const std::string& picture) {
    return "csgsim render " + model +
           " --camera 1,2,3,0,0,0 --view-all --set background.colour=0,0,1 --machine pixel-planes-4+alu.bits=2" + more +
           " --size 8x6 --memory-bits " + memory +
           " --z-bits 20 --fraction-bits 12 --colour-bits 24 --colouring rebroadcast --strategy stack --output " +
           picture;
  };
  CHECK(commands(0) == Texts{draw("m.csg", "60", "", "m-knee.png")});
  CHECK(commands(1) == Texts{draw("'a b.csg'", "70", "", "'a b-knee.png'")});
  CHECK(commands(2) == Texts{draw("m.csg", "70", "", "m-knee.png"), draw("'a b.csg'", "70", "", "'a b-knee.png'")});
  for (ExploreRow& row : rows) row.point.memory_bits = row.point.model == "m.csg" ? 200 : 90;
  CHECK(commands(0) == Texts{draw("m.csg", "200", "", "m-knee.png")});
  // The clock of a process is a figure; stack bits, curves and prunings are printed if they are not the defaults.
  rows = {made_row("m.csg", "pixel-planes-4+alu.bits=2", 10, 60)};
  rows[0].clock_hz = 123;
  CHECK(commands(0) == Texts{draw("m.csg", "60", "", "m-knee.png")});
  rows[0].clock_path = "pixel";
  CHECK(commands(0) == Texts{draw("m.csg", "60", "+clock.frequency=123", "m-knee.png")});
  rows[0].clock_path.clear();
  rows[0].point.strategy = "bits";
  rows[0].point.stack_bits = 5;
  rows[0].point.curves = "facets";
  rows[0].point.pruning = "none";
  std::string expected = draw("m.csg", "60", "", "m-knee.png");
  expected.replace(expected.find("stack --output"), 5, "bits --stack-bits 5 --curves facets --pruning none");
  CHECK(commands(0) == Texts{expected});
}

TEST_CASE("a model's knee has a command for that model and the joint knee one per model") {
  const Explored explored({"m.csg", "n.csg", "--vary", "z-bits=20"});
  std::vector<ExploreRow> rows{made_row("m.csg", "a", 10, 60), made_row("m.csg", "b", 20, 50),
                               made_row("n.csg", "a", 10, 60), made_row("n.csg", "b", 5, 90)};
  explored.study().set_rows(lines_of(rows), false);
  const Json fronts = Json::parse(explored.study().json("t"))["fronts"];
  REQUIRE(fronts.size() == 3);
  // The knee of m is b and that of n is a; over both models a takes 200 ms and 60 bits, b 250 ms and 90 bits.
  CHECK(fronts[0]["knee"]["commands"].size() == 1);
  CHECK(fronts[0]["knee"]["commands"][0].get<std::string>().find("--machine b ") != std::string::npos);
  CHECK(fronts[1]["knee"]["commands"][0].get<std::string>().find("--machine a ") != std::string::npos);
  CHECK(fronts[2]["knee"]["commands"].size() == 2);
}

TEST_CASE("a page has a table of each front with its knee and a table of commands") {
  const Explored explored({"m.csg", "n.csg", "--vary", "z-bits=20", "--axes", "time,memory"});
  std::vector<ExploreRow> rows{made_row("m.csg", "p+alu.bits=1", 10, 10), made_row("m.csg", "p+alu.bits=4", 20, 40),
                               made_row("n.csg", "p+alu.bits=1", 50, 30), made_row("n.csg", "p+alu.bits=4", 40, 40)};
  explored.study().set_rows(lines_of(rows), false);
  report::Json data = Json::parse(explored.study().json("t"));
  const std::vector<report::Section> sections = explored.study().sections(data);
  REQUIRE(sections.size() == 1);
  REQUIRE(sections[0].parts.size() == 4);
  const auto table = [&](std::size_t part) { return std::get<report::Table>(sections[0].parts[part]); };
  const auto values = [](const report::Table& one) {
    Json all = Json::array();
    for (const report::Row& row : one.rows) {
      Json cells = Json::array();
      for (const report::Cell& cell : row) cells.push_back(cell.value);
      all.push_back(std::move(cells));
    }
    return all;
  };
  CHECK(table(0).caption == "m.csg: Pareto-optimal designs");
  CHECK(table(0).columns == Texts{"knee", "alu.bits", "time", "memory"});
  CHECK(values(table(0)) == Json::parse(R"([["knee",1,100.0,10.0],["",4,50.0,40.0]])"));
  CHECK(table(1).caption == "n.csg: Pareto-optimal designs");
  CHECK(values(table(1)) == Json::parse(R"([["knee",1,20.0,30.0]])"));
  CHECK(table(2).caption == "All models: Pareto-optimal designs");
  CHECK(values(table(2)) == Json::parse(R"([["knee",1,120.0,30.0],["",4,75.0,40.0]])"));
  const Json commands = values(table(3));
  REQUIRE(commands.size() == 4);
  CHECK(commands[0][0] == "m.csg");
  CHECK(commands[0][1] == data["fronts"][0]["knee"]["commands"][0]);
  CHECK(commands[1][0] == "n.csg");
  CHECK(commands[2][0] == "all");
  CHECK(commands[3][0] == "all");
  CHECK(commands[3][1] == data["fronts"][2]["knee"]["commands"][1]);
  CHECK(table(3).is_list);
  // Without a drawn design there are no fronts.
  for (ExploreRow& row : rows) row.reason = "no";
  explored.study().set_rows(lines_of(rows), false);
  data = Json::parse(explored.study().json("t"));
  CHECK(explored.study().sections(data).empty());
}

TEST_CASE("explore rejects contradictory options and names them") {
  const Models models;
  const std::string cube = models / "cube.csg";
  CHECK(usage_error({cube, "--vary", "alu.bits=1,2", "--set", "alu.bits=4"}) ==
        "--vary: 'alu.bits' is both varied and fixed; remove one");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--set", "memory.reads=2"}) == "");
  const std::string clock = "--vary: the process determines the clock; remove clock.frequency or --process";
  CHECK(usage_error({cube, "--vary", "clock.frequency=1000000", "--process", "nmos-3um"}) == clock);
  CHECK(usage_error({cube, "--vary", "clock.frequency=1000000"}) == "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--process", "nmos-3um"}) == "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--process", "nmos"}) != "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--points", "10001"}) != "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--points", "10000"}) == "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--search", "10001"}) != "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--search", "10000"}) == "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--memory-bits", "0"}) != "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--memory-bits", "4097"}) != "");
  CHECK(usage_error({cube, "--vary", "z-bits=4", "--memory-bits", "4096"}) == "");
  CHECK(usage_error({cube, "--vary", "z-bits=4", "--memory-bits", "1"}) == "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--strategy", "auto"}) != "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--colouring", "auto"}) != "");
  CHECK(usage_error({cube, "--vary", "alu.bits=1", "--axes", "time,tim"}) != "");
  CHECK(usage_error({cube, "--vary", "alu.bits"}) != "");
  CHECK(usage_error({cube}) != "");
  CHECK(usage_error({"--vary", "alu.bits=1"}) != "");
}

TEST_CASE("designs have four axes by default and five with a process unless requested") {
  studies::ExploreOptions options;
  CHECK(options.requested_axes() == "time,area,memory,wrong");
  CHECK_FALSE(options.loaded_process());
  options.process = "nmos-3um";
  CHECK(options.requested_axes() == "time,silicon,energy,memory,wrong");
  CHECK(options.loaded_process()->name == "nmos-3um");
  options.axes = "time,wrong";
  CHECK(options.requested_axes() == "time,wrong");
  const Texts own = studies::own_explore_options();
  CHECK(std::set<std::string>(own.begin(), own.end()) ==
        std::set<std::string>{"size",       "memory-bits", "z-bits", "fraction-bits", "colour-bits", "strategy",
                              "stack-bits", "colouring",   "curves", "pruning",       "vary",        "points",
                              "seed",       "search",      "axes",   "process",       "sensitivity", "samples",
                              "machine",    "set",         "output", "threads",       "shard",       "no-plots",
                              "progress",   "report",      "quiet"});
}
