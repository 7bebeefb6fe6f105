// Tests of the explore study: the points that it requests and their measurements.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "hw/isa/program.h"
#include "hw/machines/area.h"
#include "hw/machines/kind.h"
#include "hw/process/price.h"
#include "hw/process/process.h"
#include "places.h"
#include "sim/session/model/compiled_model.h"
#include "sim/session/run/run_request.h"
#include "sim/studies/csv.h"
#include "sim/studies/fitted_program.h"
#include "tests/support/drawing.h"
#include "tests/support/error_of.h"
#include "tests/unit/studies/explored.h"

using namespace csgsim;
using studies::ExploreRow;
using testing::Explored;
using testing::Models;
using testing::row_in;
using testing::Texts;
namespace fs = std::filesystem;

TEST_CASE("explore requests each design once per model with all inputs of the point") {
  const Models models;
  const std::string cube = models / "cube.csg";
  const std::string two = models / "two.csg";
  Explored explored({cube,
                     two,
                     cube,
                     "--size",
                     "16x12",
                     "--vary",
                     "alu.bits=1,2",
                     "--vary",
                     "strategy=stack,bits",
                     "--stack-bits",
                     "5",
                     "--fraction-bits",
                     "6",
                     "--colour-bits",
                     "12",
                     "--curves",
                     "facets",
                     "--colouring",
                     "field",
                     "--pruning",
                     "none",
                     "--z-bits",
                     "15"});
  Texts expected;
  for (const std::string& model : {cube, two}) {
    for (const char* const machine : {"pixel-planes-4+alu.bits=1", "pixel-planes-4+alu.bits=2"}) {
      for (const char* const strategy : {"stack,0", "bits,5"})
        expected.push_back(model + "," + machine + ",,,16,12,15,6,12,none,field," + strategy + ",facets");
    }
  }
  CHECK(explored.ask() == expected);
  // The inputs for one model differ in the machine only.
  CHECK(explored.asked[0].inputs == explored.asked[1].inputs);
  CHECK(explored.asked[0].inputs.machine_hash != explored.asked[2].inputs.machine_hash);
  CHECK(explored.asked[0].inputs.model_hash == explored.asked[2].inputs.model_hash);
  CHECK(explored.asked[0].inputs.model_hash != explored.asked[4].inputs.model_hash);
  CHECK(explored.asked[0].inputs.machine_hash == explored.asked[4].inputs.machine_hash);
}

TEST_CASE("a study point lists its memory if an option, varied key or parameter sets it") {
  const Models models;
  const std::string cube = models / "cube.csg";
  const auto memory = [&](const Texts& words) {
    Texts all{cube, "--size", "16x12"};
    all.insert(all.end(), words.begin(), words.end());
    Texts cells;
    for (const std::string& row : Explored(all).ask()) cells.push_back(std::string(studies::split_cells(row).at(3)));
    return cells;
  };
  CHECK(memory({"--vary", "z-bits=12,14"}) == Texts{"", ""});
  CHECK(memory({"--vary", "z-bits=12", "--memory-bits", "80"}) == Texts{"80"});
  CHECK(memory({"--vary", "memory-bits=80,90"}) == Texts{"80", "90"});
  CHECK(memory({"--vary", "array.memory_bits=81,91"}) == Texts{"81", "91"});
  CHECK(memory({"--vary", "z-bits=12", "--set", "array.memory_bits=82"}) == Texts{"82"});
  CHECK(memory({"--vary", "z-bits=12", "--set", "alu.bits=2"}) == Texts{""});
  CHECK(memory({"--vary", "alu.bits=1", "--set", "array.memory_bits=82"}) == Texts{"82"});
}

TEST_CASE("each point of explore states its process and has its parameters as inputs") {
  const Models models;
  const auto requested = [&](const Texts& words) {
    Texts all{models / "cube.csg", "--size", "16x12", "--vary", "z-bits=12"};
    all.insert(all.end(), words.begin(), words.end());
    Explored explored(all);
    explored.ask();
    return explored.asked.front();
  };
  const studies::PointRequest plain = requested({});
  const studies::PointRequest made = requested({"--process", "nmos-3um"});
  CHECK(studies::split_cells(plain.cells).at(2).empty());
  CHECK(studies::split_cells(made.cells).at(2) == "nmos-3um");
  CHECK(plain.inputs.machine_hash != made.inputs.machine_hash);
  CHECK(made.inputs.machine_hash != requested({"--process", "cmos-45nm"}).inputs.machine_hash);
  CHECK(made.inputs == requested({"--process", "nmos-3um"}).inputs);
  CHECK(made.inputs.model_hash == plain.inputs.model_hash);
}

TEST_CASE("explore reports inconsistent parameters and unreadable models in the row") {
  const Models models;
  Explored explored({models / "cube.csg", "--size", "16x12", "--vary", "evaluator.bits=1,4", "--vary", "alu.bits=1,4"});
  const Texts cells = explored.ask();
  REQUIRE(cells.size() == 4);
  const Texts rows = explored.measure();
  for (std::size_t i = 0; i < 4; ++i) {
    const ExploreRow row = row_in(rows[i]);
    CHECK(row.is_compiled() == (i != 2));
    CHECK(row.point.width == (i != 2 ? 16 : 0));
    CHECK(row.point.height == (i != 2 ? 12 : 0));
    CHECK((row.clocks > 0) == (i != 2));
    CHECK(row.inputs == explored.asked[i].inputs);
    CHECK(studies::to_line(row).starts_with(cells[i] + ","));
  }
  CHECK(row_in(rows[2]).reason.find("evaluator.bits is 4 and alu.bits 1") != std::string::npos);
  explored.study().refuse();

  Explored unread({models / "wrong.csg", models / "cube.csg", "--size", "16x12", "--vary", "z-bits=12"});
  unread.ask();
  const Texts of_both = unread.measure();
  CHECK(row_in(of_both[0]).reason.find("wrong.csg:1:") != std::string::npos);
  CHECK(row_in(of_both[1]).is_compiled());
  CHECK(testing::error_of([&] { unread.study().refuse(); }).find("explore.csv") != std::string::npos);
  CHECK(testing::error_of([&] {
          Explored({models / "wrong.csg", "--vary", "z-bits=12,13"}).ask();
        }).find("wrong.csg:1:") != std::string::npos);
}

TEST_CASE("explore compares no transparent model with exact pictures") {
  const Models models;
  models.write("glass.csg", "color([1, 0, 0, 0.5]) { cube(size = [8, 6, 4]); }\n");
  Explored explored({models / "glass.csg", models / "cube.csg", "--size", "16x12", "--vary", "z-bits=12,13"});
  explored.ask();
  const Texts rows = explored.measure();
  REQUIRE(rows.size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    CAPTURE(rows[i]);
    CHECK((row_in(rows[i]).reason.find("supports opaque solids only") != std::string::npos) == (i < 2));
  }
}

TEST_CASE("an explore row equals the stats and wrong pixels at the smallest fitting memory") {
  const Models models;
  const Texts words{models / "two.csg", "--size", "16x12", "--z-bits", "12"};
  Texts requested = words;
  requested.insert(requested.end(), {"--vary", "alu.bits=1,2", "--process", "cmos-45nm"});
  Explored explored(requested);
  explored.ask();
  const Texts rows = explored.measure();
  const process::Process process = process::load_process("cmos-45nm");
  for (std::size_t i = 0; i < 2; ++i) {
    const ExploreRow row = row_in(rows[i]);
    REQUIRE(row.is_compiled());
    // The expected values are measured by the code of csgsim render.
    Texts render = words;
    render.insert(render.end(), {"--machine", row.point.machine, "--memory-bits", std::to_string(row.used_bits)});
    const session::ModelRequest options = session::parse_model_request(render);
    machines::Machine machine = session::machine_of(options);
    const isa::Program program = session::compile_model(options, machine).program;
    machine.clock_hz = process::clock_of(machine, process)->hz;
    const session::DrawnRun drawn = session::draw(program, machine);
    CHECK(row.halfspaces == 12);  // two cubes
    std::uint64_t instructions = 0;
    for (const isa::Segment& segment : program.segments) instructions += segment.instructions.size();
    CHECK(row.instructions == instructions);
    CHECK(row.clock_hz == machine.clock_hz);
    CHECK(row.clock_path == process::clock_of(machine, process)->path.name);
    CHECK(row.clocks == drawn.result.clocks);
    CHECK(row.interval_clocks == drawn.result.interval_clocks);
    CHECK(row.frames_per_second * static_cast<double>(row.interval_clocks) ==
          doctest::Approx(static_cast<double>(row.clock_hz)));
    CHECK(row.processors == 16 * 12);
    CHECK(row.machine_memory_bits == std::uint64_t{16 * 12} * row.used_bits);
    REQUIRE(row.pixel_transistors);
    CHECK(row.pixel_transistors == machines::pixel_transistors(machine, row.used_bits));
    CHECK(row.machine_transistors == *row.pixel_transistors * 16 * 12);
    REQUIRE(row.machine_mm2);
    const machines::Resources resources = machine.kind->resources(machine, isa::frame_header(program));
    CHECK(*row.machine_mm2 == doctest::Approx(process::machine_mm2(machine, resources, process).value()));
    REQUIRE(row.frame_joules);
    studies::RunTimer timer;
    const std::uint64_t pixel_clocks = process::pixel_clocks(program, machine, timer.outcome(program, machine).skips);
    const double seconds = static_cast<double>(drawn.result.interval_clocks) / static_cast<double>(machine.clock_hz);
    CHECK(*row.frame_joules ==
          doctest::Approx(process::frame_joules(machine, resources, {pixel_clocks, seconds}, process).value()));
    CHECK(row.unexplained == 0);
  }
  const ExploreRow narrow = row_in(rows[0]);
  const ExploreRow wide = row_in(rows[1]);
  CHECK(narrow.clocks > wide.clocks);
  CHECK(narrow.pixel_transistors < wide.pixel_transistors);
}

TEST_CASE("without a process a machine has the clock of its description and no area") {
  const Models models;
  Explored explored({models / "cube.csg", "--size", "16x12", "--vary", "memory-bits=100,120"});
  explored.ask();
  const Texts rows = explored.measure();
  for (std::size_t i = 0; i < 2; ++i) {
    const ExploreRow row = row_in(rows[i]);
    CHECK(row.clock_hz == 10'000'000);
    CHECK(row.clock_path.empty());
    CHECK_FALSE(row.machine_mm2);
    CHECK_FALSE(row.frame_joules);
    CHECK(row.halfspaces == 6);
    // The machine has the requested memory, although the Program uses less.
    CHECK(row.machine_memory_bits == std::uint64_t{16 * 12} * (i == 0 ? 100 : 120));
    CHECK(row.used_bits < 100);
  }
  CHECK(row_in(rows[0]).used_bits == row_in(rows[1]).used_bits);
}

TEST_CASE("designs measured together have the results of separate measurements") {
  const std::string house = testing::model_path("rietveld_house");
  const Texts common{"--size", "40x32", "--camera", "3430,-2900,1950,590,230,220", "--z-bits", "9"};
  std::set<std::uint64_t> wrong;
  for (const char* const vary : {"z-bits=6,7,9", "fraction-bits=0,12", "size=24x20,40x32", "strategy=stack,list"}) {
    CAPTURE(vary);
    Texts words{house};
    words.insert(words.end(), common.begin(), common.end());
    words.insert(words.end(), {"--vary", vary});
    Explored together(words);
    const Texts cells = together.ask();
    const Texts rows = together.measure();
    for (std::size_t i = 0; i < rows.size(); ++i) {
      Texts one = words;
      const std::string text = vary;
      const std::size_t equals = text.find('=');
      Texts values;
      for (std::size_t at = equals + 1; at <= text.size();) {
        const std::size_t end = std::min(text.find(',', at), text.size());
        values.push_back(text.substr(at, end - at));
        at = end + 1;
      }
      one.back() = text.substr(0, equals + 1) + values.at(i);
      Explored alone(one);
      CHECK(alone.ask() == Texts{cells[i]});
      CHECK(alone.measure() == Texts{rows[i]});
      wrong.insert(row_in(rows[i]).wrong);
      CHECK(row_in(rows[i]).unexplained == 0);
    }
  }
  CHECK(wrong.size() > 3);
}

TEST_CASE("explore lists models and scene and machine and process files as inputs") {
  const Explored explored({"a.csg", "b.csg", "--vary", "z-bits=12"});
  CHECK(explored.study().inputs() == std::vector<fs::path>{"a.csg", "b.csg"});
  const Models models;
  models.write("scene.toml", "");
  for (const char* const name : {"pixel-planes-4.toml", "nmos-3um.toml"}) {
    const std::string folder = name == std::string("nmos-3um.toml") ? "/hw/process/" : "/hw/machines/";
    fs::copy_file(std::string(CSGSIM_SOURCE_DIR) + folder + name, models / name);
  }
  const Explored files({"a.csg", "--vary", "z-bits=12", "--scene", models / "scene.toml", "--machine",
                        models / "pixel-planes-4.toml", "--process", (models / "nmos-3um.toml") + "+wire.delay=1"});
  const std::vector<fs::path> read = files.study().inputs();
  CHECK(std::set<fs::path>(read.begin(), read.end()) ==
        std::set<fs::path>{"a.csg", models / "scene.toml", models / "pixel-planes-4.toml", models / "nmos-3um.toml"});
  CHECK(explored.study().varied_options() ==
        std::set<std::string>{"vary", "points", "seed", "search", "axes", "machine", "process", "sensitivity",
                              "samples", "size", "memory-bits", "z-bits", "fraction-bits", "colour-bits", "strategy",
                              "stack-bits", "colouring", "curves", "pruning"});
  CHECK_FALSE(explored.study().is_adaptive());
  CHECK(Explored({"a.csg", "--vary", "z-bits=12", "--search", "1"}).study().is_adaptive());
  CHECK(explored.study().page_title() == "Design space");
  CHECK(explored.study().page_subject().name == "2 models");
  CHECK(explored.study().page_subject().model.model == "a.csg");
  CHECK(Explored({"a.csg", "a.csg", "--vary", "z-bits=12"}).study().page_subject().name.empty());
}

TEST_CASE("a search requests neighbours of the front until its limit or until none is left") {
  const Models models;
  const auto counts = [&](const char* most) {
    Explored explored({models / "cube.csg", "--size", "12x8", "--vary", "z-bits=10..14", "--vary", "alu.bits=1,2,4",
                       "--points", "1", "--search", most, "--axes", "time,area"});
    std::vector<std::size_t> rounds{explored.ask().size()};
    explored.measure();
    for (int i = 0; i < 20; ++i) {
      const std::vector<studies::PointRequest> more = explored.study().request_more_points();
      if (more.empty()) break;
      rounds.push_back(more.size());
      explored.asked.insert(explored.asked.end(), more.begin(), more.end());
      explored.measure();
    }
    return std::pair(rounds, explored.cells());
  };
  const auto [one, first] = counts("1");
  CHECK(one == std::vector<std::size_t>{1, 1});
  // The only design of the front has two to four neighbours.
  const auto [three, cells] = counts("3");
  CHECK(three.front() == 1);
  CHECK(std::accumulate(three.begin(), three.end(), std::size_t{0}) == 1 + 3);
  CHECK(std::set<std::string>(cells.begin(), cells.end()).size() == cells.size());
  CHECK(first == Texts{cells[0], cells[1]});
  // A search with a high limit ends when all neighbours of the front, at most 15 designs, have been tried.
  const auto [all, of_all] = counts("100");
  const std::size_t total = std::accumulate(all.begin(), all.end(), std::size_t{0});
  CHECK(total > 4);
  CHECK(total <= 15);
  CHECK(std::set<std::string>(of_all.begin(), of_all.end()).size() == total);
  CHECK(counts("0").first == std::vector<std::size_t>{1});
}

TEST_CASE("a search requests neighbours of the joint front for each model") {
  const Models models;
  Explored explored({models / "cube.csg", models / "two.csg", "--size", "12x8", "--vary", "z-bits=10..14", "--points",
                     "1", "--search", "9", "--axes", "time"});
  REQUIRE(explored.ask().size() == 2);
  explored.measure();
  const std::vector<studies::PointRequest> more = explored.study().request_more_points();
  // One or two adjacent z bits of either model.
  CHECK(more.size() % 2 == 0);
  CHECK(more.size() >= 2);
  CHECK(more.size() <= 4);
  for (std::size_t i = 0; i < more.size(); ++i) {
    const bool is_first = i < more.size() / 2;
    CHECK(more[i].cells.starts_with(models / (is_first ? "cube.csg" : "two.csg")));
  }
}