#include <doctest/doctest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "host/read/read.h"
#include "hw/base/error.h"
#include "hw/kinds/load.h"
#include "sim/session/model/model_request.h"
#include "sim/studies/accuracy/measure.h"
#include "sim/studies/accuracy/show.h"
#include "sim/studies/compare/measure.h"
#include "sim/studies/csv.h"
#include "sim/studies/row_text.h"

using namespace csgsim;

namespace {

studies::Measurement point(const std::string& value, std::uint64_t clocks, std::uint64_t wrong) {
  studies::Measurement measurement;
  measurement.knob = "together";
  measurement.value = value;
  measurement.clocks = clocks;
  measurement.wrong = wrong;
  return measurement;
}

machines::Machine small_machine() {
  machines::Machine machine = kinds::load("pixel-planes-4");
  machine.array = {96, 96, session::ample_memory_bits};
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

TEST_CASE("the Pareto front has the points that no other beats in clocks and wrong pixels") {
  const std::vector<studies::Measurement> all{point("d", 40, 2), point("a", 10, 90), point("c", 30, 50),
                                              point("b", 20, 50), point("e", 50, 2)};
  std::string names;
  for (const studies::Measurement& one : studies::pareto_front(all)) names += one.value;
  CHECK(names == "abd");
}

TEST_CASE("each halving leads to the cheapest point with at most half as many wrong pixels") {
  const std::vector<studies::Measurement> front{point("a", 100, 90), point("b", 110, 50), point("c", 120, 45),
                                                point("d", 180, 3), point("e", 200, 0)};
  const std::vector<studies::Halving> steps = studies::halvings(front);
  REQUIRE(steps.size() == 3);
  CHECK(steps[0].from.value + steps[0].to.value == "ac");
  CHECK(steps[0].more_clocks == doctest::Approx(0.2));
  CHECK(steps[1].from.value + steps[1].to.value == "cd");
  CHECK(steps[1].more_clocks == doctest::Approx(0.5));
  CHECK(steps[2].from.value + steps[2].to.value == "de");
}

TEST_CASE("more depth bits take more clocks and do not increase depth errors") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  studies::Meter meter(tree, studies::rotated_cameras(camera, 3), small_machine(), {});
  std::uint64_t clocks = 0;
  double depth = 1e300;
  for (const unsigned bits : {8U, 12U, 16U, 20U}) {
    studies::Settings settings{"z-bits", std::to_string(bits), {}, small_sampling()};
    settings.sampling.z_bits = bits;
    const studies::Measurement measurement = meter.measure(settings);
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

TEST_CASE("accuracy sums counts over its views and takes the worst depth error") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  const std::vector<view::Camera> views = studies::rotated_cameras(camera, 2);
  studies::Settings settings{"z-bits", "8", {}, small_sampling()};
  settings.sampling.z_bits = 8;
  const auto measured = [&](std::vector<view::Camera> cameras) {
    return studies::Meter(tree, std::move(cameras), small_machine(), {}).measure(settings);
  };
  const studies::Measurement both = measured(views);
  const studies::Measurement first = measured({views[0]});
  const studies::Measurement second = measured({views[1]});
  for (std::uint64_t studies::Measurement::*const count :
       {&studies::Measurement::clocks, &studies::Measurement::covered, &studies::Measurement::wrong,
        &studies::Measurement::wrong_silhouette, &studies::Measurement::wrong_owner, &studies::Measurement::unexplained,
        &studies::Measurement::facet_wrong})
    CHECK(both.*count == first.*count + second.*count);
  for (double studies::Measurement::*const depth :
       {&studies::Measurement::depth_max, &studies::Measurement::depth_p999, &studies::Measurement::depth_max_steps,
        &studies::Measurement::depth_p999_steps, &studies::Measurement::facet_depth_p999})
    CHECK(both.*depth == std::max(first.*depth, second.*depth));
  CHECK(both.wrong > 0);
  CHECK(first.depth_max != second.depth_max);
}

TEST_CASE("a tighter faceting tolerance improves the picture for more half-spaces") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  studies::Meter meter(tree, {camera}, small_machine(), {});
  double error = 1e300;
  std::uint64_t halfspaces = 0;
  for (const double tolerance : {0.5, 0.1, 0.02}) {
    const studies::Measurement measurement =
        meter.measure({"tolerance", "t", {tolerance, std::nullopt}, small_sampling()});
    CHECK(measurement.halfspaces > halfspaces);
    CHECK(measurement.facet_depth_p999 < error);
    CHECK(measurement.facet_depth_p999 > 0);
    halfspaces = measurement.halfspaces;
    error = measurement.facet_depth_p999;
  }
}

TEST_CASE("the cheapest settings that fit the machine and the wrong-pixel limit are chosen") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  studies::Meter meter(tree, {camera}, small_machine(), {});
  const std::vector<studies::Settings> grid = studies::bit_width_pairs(small_sampling(), {});
  const auto chosen = studies::cheapest_settings(meter, grid, 10);
  REQUIRE(chosen);
  CHECK(meter.measure(*chosen).wrong <= 10);
  for (const studies::Settings& other : grid) {
    if (meter.measure(other).wrong <= 10) CHECK(meter.clocks(other) >= meter.clocks(*chosen));
  }
  machines::Machine tight = small_machine();
  tight.array.memory_bits = 2 * 12 + 24 + 3;
  studies::Meter in_little_memory(tree, {camera}, tight, {});
  const auto little = studies::cheapest_settings(in_little_memory, grid, 1000);
  REQUIRE(little);
  CHECK(little->sampling.z_bits <= 12);
}

namespace {

studies::Measurement faceted(const char* knob, const char* value, std::uint64_t clocks, std::uint64_t off) {
  studies::Measurement measurement = point(value, clocks, 0);
  measurement.knob = knob;
  measurement.facet_wrong = off;
  return measurement;
}

}  // namespace

TEST_CASE("facets as accurate as exact curves are the cheapest with no more pixels off") {
  std::vector<studies::Measurement> rows{faceted("fn", "8", 10, 90),          faceted("fn", "64", 70, 5),
                                         faceted("tolerance", "0.1", 60, 4),  faceted("tolerance", "0.01", 90, 0),
                                         faceted("curves", "facets", 30, 40), faceted("curves", "exact", 20, 5),
                                         faceted("z-bits", "24", 5, 0)};
  const auto all = studies::equally_accurate_facets(rows);
  REQUIRE(all.size() == 1);
  CHECK(all[0].curved.value == "exact");
  CHECK(all[0].facets.value == "0.1");
  CHECK(all[0].is_as_accurate);
  rows[5].facet_wrong = 40;
  CHECK(studies::equally_accurate_facets(rows)[0].facets.value == "facets");
  rows[3].facet_wrong = 3;
  rows[5].facet_wrong = 2;
  const auto nearest = studies::equally_accurate_facets(rows);
  CHECK(nearest[0].facets.value == "0.01");
  CHECK_FALSE(nearest[0].is_as_accurate);
  CHECK(studies::equally_accurate_facets(std::vector{rows[5]}).empty());
}

TEST_CASE("exact curves have far smaller depth errors and fewer half-spaces than facets") {
  const model::Tree tree = read::read_csg_text(bitten_cube, "test");
  machines::Machine machine = kinds::load("pixel-powers");
  machine.array = {96, 96, session::ample_memory_bits};
  studies::Meter meter(tree, studies::rotated_cameras(camera, 2), machine, {});
  studies::Knobs knobs{{"curves", "tolerance"}, {0.05}, {}};
  for (const studies::CurvesChoice& choice : studies::curves_choices()) knobs.curves.push_back(choice);
  std::vector<studies::Measurement> rows;
  for (const studies::Settings& settings : studies::accuracy_points(small_sampling(), {}, knobs))
    rows.push_back(meter.measure(settings));
  const auto row = [&](const std::string& value) {
    const auto found = std::ranges::find(rows, value, &studies::Measurement::value);
    REQUIRE(found != rows.end());
    return *found;
  };
  CHECK(row("exact").unexplained == 0);
  CHECK(row("facets").unexplained == 0);
  CHECK(row("exact").facet_wrong <= row("exact").wrong);
  CHECK(row("facets").facet_wrong > 10);
  CHECK(row("exact").facet_depth_p999 < 1e-3 * row("facets").facet_depth_p999);
  CHECK(row("exact").facet_depth_p999 < 1e-2 * row("0.05").facet_depth_p999);
  CHECK(row("exact").halfspaces < row("facets").halfspaces);
}

TEST_CASE("accuracy varies only the requested settings") {
  studies::Knobs knobs{{"tolerance", "size"}, {0.5, 0.25}, {}};
  std::vector<std::string> points;
  for (const studies::Settings& one : studies::accuracy_points(small_sampling(), {}, knobs))
    points.push_back(one.knob + " " + one.value);
  CHECK(points == std::vector<std::string>{"size 12x12", "size 24x24", "size 48x48", "size 96x96", "tolerance 0.5",
                                           "tolerance 0.25"});
}

TEST_CASE("a row of compare has a cell for each column and survives a round trip") {
  studies::ComparisonRow row;
  row.point = {"a machine", 1001, 1002, 1003, "an ideal"};
  row.inputs = {"a model", "a hash", "a build"};
  std::uint64_t number = 1004;
  for (std::uint64_t studies::ComparisonRow::*const count :
       {&studies::ComparisonRow::primitives, &studies::ComparisonRow::halfspaces, &studies::ComparisonRow::segments,
        &studies::ComparisonRow::drawn_segments, &studies::ComparisonRow::instructions, &studies::ComparisonRow::clocks,
        &studies::ComparisonRow::shown_clocks, &studies::ComparisonRow::interval_clocks,
        &studies::ComparisonRow::host_clocks, &studies::ComparisonRow::host_model_clocks,
        &studies::ComparisonRow::pixel_operations, &studies::ComparisonRow::enabled,
        &studies::ComparisonRow::processors, &studies::ComparisonRow::processor_clocks,
        &studies::ComparisonRow::machine_memory_bits, &studies::ComparisonRow::instruction_clocks})
    row.*count = number++;
  row.pixel_transistors = number++;
  row.machine_transistors = number++;
  for (double studies::ComparisonRow::*const fraction :
       {&studies::ComparisonRow::simulated_seconds, &studies::ComparisonRow::frames_per_second,
        &studies::ComparisonRow::hosted_frames_per_second, &studies::ComparisonRow::utilisation,
        &studies::ComparisonRow::bound_share})
    row.*fraction = static_cast<double>(number++);
  row.frame_joules = static_cast<double>(number++);
  row.bound_by = "a part";
  row.dearest = {{"cube@1:1", 7}};
  row.picture = "a picture";
  row.surfaces = "surfaces";
  row.reason = "a reason";
  std::vector<std::string> cells = studies::split_cells(studies::to_line(row));
  CHECK(studies::split_cells(studies::header_line<studies::ComparisonRow>()).size() == cells.size());
  std::vector<std::string> expected{"a machine", "an ideal",  "a model",  "a hash",   "a build",
                                    "a part",    "a picture", "surfaces", "a reason", "cube@1:1=7"};
  for (std::uint64_t i = 1001; i < number; ++i) expected.push_back(std::to_string(i));
  std::ranges::sort(cells);
  std::ranges::sort(expected);
  CHECK(cells == expected);
  CHECK(studies::to_line(studies::from_line<studies::ComparisonRow>(studies::to_line(row))) == studies::to_line(row));
}
