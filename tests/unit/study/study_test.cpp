#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "host/read/read.h"
#include "hw/base/error.h"
#include "hw/kinds/load.h"
#include "sim/study/measure.h"
#include "sim/study/pareto.h"
#include "sim/study/table.h"

using namespace csgsim;

namespace {

using Table = study::Table<study::Measurement>;

study::Measurement point(const std::string& value, std::uint64_t clocks, std::uint64_t wrong) {
  study::Measurement measurement;
  measurement.knob = "together";
  measurement.value = value;
  measurement.clocks = clocks;
  measurement.wrong = wrong;
  return measurement;
}

std::filesystem::path fresh(const std::string& name) {
  std::filesystem::path path = std::filesystem::path(CSGSIM_BINARY_DIR) / name;
  std::filesystem::remove(path);
  return path;
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

machines::Machine small_machine() {
  machines::Machine machine = kinds::load("pixel-planes-4");
  machine.array = {96, 96, study::ample_memory_bits};
  return machine;
}

view::Sampling small_sampling() {
  view::Sampling sampling;
  sampling.width = sampling.height = 96;
  return sampling;
}

const view::Camera camera{{40, -60, 45}, {0, 0, 0}, view::Projection::orthographic};
const char* const bitten_cube = "difference(){cube(size=14,center=true);sphere($fn=24,$fa=12,$fs=2,r=9);}";

}  // namespace

TEST_CASE("the Pareto front has what no other point beats in clocks and in wrong pixels") {
  const std::vector<study::Measurement> all{point("d", 40, 2), point("a", 10, 90), point("c", 30, 50),
                                            point("b", 20, 50), point("e", 50, 2)};
  std::string names;
  for (const study::Measurement& one : study::pareto_front(all)) names += one.value;
  CHECK(names == "abd");
}

TEST_CASE("halvings go from each point to the cheapest with at most half its wrong pixels") {
  const std::vector<study::Measurement> front{point("a", 100, 90), point("b", 110, 50), point("c", 120, 45),
                                              point("d", 180, 3), point("e", 200, 0)};
  const std::vector<study::Halving> steps = study::halvings(front);
  REQUIRE(steps.size() == 3);
  CHECK(steps[0].from.value + steps[0].to.value == "ac");
  CHECK(steps[0].more_clocks == doctest::Approx(0.2));
  CHECK(steps[1].from.value + steps[1].to.value == "cd");
  CHECK(steps[1].more_clocks == doctest::Approx(0.5));
  CHECK(steps[2].from.value + steps[2].to.value == "de");
}

TEST_CASE("a table goes on where it was interrupted, even in the middle of a line") {
  const std::filesystem::path path = fresh("study_table.csv");
  study::Measurement first = point("10/2", 1234, 56);
  first.depth_p999 = 0.1234567890123456789;
  {
    Table table(path, "a study");
    table.add(first);
    table.add(point("12/2", 2345, 5));
  }
  std::ofstream(path, std::ios::app) << "together,14/2,99";
  Table table(path, "a study");
  REQUIRE(table.rows().size() == 2);
  CHECK(table.rows()[0] == first);
  study::WantedSettings wanted;
  wanted.point.knob = "together";
  wanted.point.value = "12/2";
  CHECK(table.find(wanted) != nullptr);
  wanted.point.value = "14/2";
  CHECK(table.find(wanted) == nullptr);
  table.add(point("14/2", 3456, 0));
  CHECK(Table(path, "a study").rows().size() == 3);
}

TEST_CASE("a table of another study is refused and kept") {
  const std::filesystem::path path = fresh("study_other.csv");
  Table(path, "one study").add(point("10/2", 1, 2));
  const std::string before = content(path);
  CHECK_THROWS_AS(Table(path, "another study"), InputError);
  CHECK(content(path) == before);
}

TEST_CASE("a table with a broken line says which") {
  const std::filesystem::path path = fresh("study_broken.csv");
  Table(path, "a study").add(point("10/2", 1, 2));
  std::ofstream(path, std::ios::app) << "together,12/2,model,machine,0.1.0,many\n";
  try {
    Table table(path, "a study");
    FAIL("read");
  } catch (const InputError& error) {
    CHECK(std::string(error.what()).find("study_broken.csv:4:1: 'many'") != std::string::npos);
  }
}

TEST_CASE("more bits of depth cost clocks and leave no more wrong pixels beyond the stated bounds") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  study::Meter meter(tree, study::turned_views(camera, 3), small_machine(), {});
  std::uint64_t clocks = 0;
  double depth = 1e300;
  for (const unsigned bits : {8U, 12U, 16U, 20U}) {
    study::Settings settings{"z-bits", std::to_string(bits), {}, small_sampling()};
    settings.sampling.z_bits = bits;
    const study::Measurement measurement = meter.measure(settings);
    CAPTURE(bits);
    CHECK(measurement.unexplained == 0);
    CHECK(measurement.covered > 3000);
    CHECK(measurement.clocks > clocks);
    CHECK(measurement.depth_p999 < depth);
    CHECK(meter.clocks(settings) == measurement.clocks);
    clocks = measurement.clocks;
    depth = measurement.depth_p999;
  }
}

TEST_CASE("a tighter faceting tolerance brings the picture nearer to the curved surface, for more half-spaces") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  study::Meter meter(tree, {camera}, small_machine(), {});
  double error = 1e300;
  std::uint64_t halfspaces = 0;
  for (const double tolerance : {0.5, 0.1, 0.02}) {
    const study::Measurement measurement =
        meter.measure({"tolerance", "t", {tolerance, std::nullopt}, small_sampling()});
    CHECK(measurement.halfspaces > halfspaces);
    CHECK(measurement.facet_depth_p999 < error);
    CHECK(measurement.facet_depth_p999 > 0);
    halfspaces = measurement.halfspaces;
    error = measurement.facet_depth_p999;
  }
}

TEST_CASE("the cheapest settings with few enough wrong pixels are chosen, and fit the machine") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  study::Meter meter(tree, {camera}, small_machine(), {});
  const std::vector<study::Settings> grid = study::grid(small_sampling(), {});
  const auto chosen = study::cheapest(meter, grid, 10);
  REQUIRE(chosen);
  CHECK(meter.measure(*chosen).wrong <= 10);
  for (const study::Settings& other : grid) {
    if (meter.measure(other).wrong <= 10) CHECK(meter.clocks(other) >= meter.clocks(*chosen));
  }
  machines::Machine tight = small_machine();
  tight.array.memory_bits = 2 * 12 + 24 + 3;
  study::Meter in_little_memory(tree, {camera}, tight, {});
  const auto little = study::cheapest(in_little_memory, grid, 1000);
  REQUIRE(little);
  CHECK(little->sampling.z_bits <= 12);
}
