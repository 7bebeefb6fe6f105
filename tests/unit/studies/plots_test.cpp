#include <doctest/doctest.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <variant>
#include <vector>

#include "sim/studies/accuracy/show.h"
#include "sim/studies/compare/measure.h"
#include "sim/studies/corpus/measure.h"
#include "sim/studies/sweep/show.h"

using namespace csgsim;

namespace {

using Words = std::vector<std::string>;

studies::SweepRow row(const studies::DesignPoint& point, std::uint64_t clocks) {
  studies::SweepRow one;
  one.point = point;
  one.clocks = clocks;
  one.classification_bits = point.stack_bits;
  one.memory_map = {{"Z2", 0, 20}};
  return one;
}

studies::DesignPoint point(const std::string& strategy, unsigned stack_bits, const std::string& pruning = "all") {
  return {.model = "a.csg",
          .machine = "pixel-planes-4",
          .memory_bits = 72,
          .z_bits = 20,
          .pruning = pruning,
          .colouring = "rebroadcast",
          .strategy = strategy,
          .stack_bits = stack_bits};
}

Words tick_texts(const plots::Axis& axis) {
  Words words;
  for (const plots::Tick& tick : axis.ticks) words.push_back(tick.text);
  return words;
}

plots::Chart chart_named(const std::vector<plots::Plot>& all, const std::string& name) {
  const auto found = std::ranges::find(all, name, &plots::Plot::name);
  REQUIRE(found != all.end());
  return std::get<plots::Chart>(found->content);
}

}  // namespace

TEST_CASE("a sweep's x axis is its most varied parameter with numbers before names") {
  using Rows = std::vector<studies::SweepRow>;
  const Rows stack_bits{row(point("stack", 0), 1), row(point("bits", 3), 2), row(point("bits", 4), 3)};
  CHECK(tick_texts(studies::SweepAxis(stack_bits).axis()) == Words{"3", "4"});
  const Rows prunings{row(point("bits", 3, "all"), 1), row(point("bits", 3, "no-sets"), 2),
                      row(point("bits", 4, "none"), 3)};
  CHECK(studies::SweepAxis(prunings).axis().title == "pruning");
  CHECK(studies::SweepAxis(prunings).axis().is_names);
  CHECK(studies::SweepAxis(prunings).other_settings(prunings[2].point) == "bits, m = 4");
  const Rows strategies{row(point("stack", 0), 1), row(point("list", 0), 2)};
  CHECK(tick_texts(studies::SweepAxis(strategies).axis()) == Words{"stack", "list"});
  Rows both = stack_bits;
  both[1].point.z_bits = 16;
  CHECK(studies::SweepAxis(both).axis().title == "depth bits");
  both.push_back(row(point("bits", 5), 4));
  CHECK(studies::SweepAxis(both).axis().title == "stack bits (m)");
}

TEST_CASE("a sweep over machines has their names on the x axis of its plot") {
  studies::DesignPoint other = point("stack", 0);
  other.machine = "alu-4.toml";
  const std::vector<studies::SweepRow> rows{row(point("stack", 0), 100), row(other, 50)};
  const plots::Chart chart = chart_named(studies::plots_of_sweep(rows, "a"), "a_clocks");
  CHECK(tick_texts(chart.x) == Words{"pixel-planes-4", "alu-4.toml"});
  REQUIRE(chart.series.size() == 1);
  CHECK(chart.series[0].points[1].x == 1);
  CHECK(chart.series[0].points[1].y == 50);
}

TEST_CASE("a sweep's plot has the requested names of prunings even with a common prefix") {
  studies::DesignPoint space = point("stack", 0);
  space.pruning = "space";
  studies::DesignPoint both = point("stack", 0);
  both.pruning = "space+hidden";
  const std::vector<studies::SweepRow> rows{row(space, 100), row(both, 50)};
  CHECK(tick_texts(studies::SweepAxis(rows).axis()) == Words{"space", "space+hidden"});
}

TEST_CASE("a strategy without stack bits is a level line and coincident lines are merged") {
  const std::vector<studies::SweepRow> rows{row(point("stack", 0), 7), row(point("list", 0), 7),
                                            row(point("bits", 4), 8), row(point("bits", 3), 9)};
  const std::vector<plots::Plot> all = studies::plots_of_sweep(rows, "a");
  const plots::Chart chart = chart_named(all, "a_clocks");
  REQUIRE(chart.series.size() == 2);
  CHECK(chart.series[0].name == "stack; list");
  CHECK(chart.series[0].trace == plots::Trace::level);
  CHECK(chart.series[1].points.front().x == 3);
  CHECK(chart.series[1].points.back().y == 8);
}

TEST_CASE("lines with the same name look alike in all plots of a sweep") {
  std::vector<studies::SweepRow> rows{row(point("stack", 0), 7), row(point("list", 0), 8), row(point("bits", 3), 9),
                                      row(point("bits", 4), 6)};
  rows[1].rendered = 5;  // its line must differ from that of the stack
  const std::vector<plots::Plot> all = studies::plots_of_sweep(rows, "a");
  std::map<std::string, std::set<std::size_t>> looks;
  for (const char* const name : {"a_scan_conversions", "a_clocks", "a_bits"}) {
    const plots::Chart chart = chart_named(all, name);
    for (const plots::Series& series : chart.series) {
      CAPTURE(series.name);
      REQUIRE(chart.looks.contains(series.name));
      looks[series.name].insert(chart.looks.at(series.name));
    }
  }
  CHECK(looks.size() > 2);
  for (const auto& [name, of_name] : looks) CHECK(of_name.size() == 1);
}

TEST_CASE("points of a sweep share a memory bar only for equal layouts and sizes") {
  std::vector<studies::SweepRow> rows{row(point("stack", 0), 7), row(point("list", 0), 8), row(point("bits", 3), 9),
                                      row(point("bits", 4), 6)};
  rows[2].point.memory_bits = 96;
  rows[3].memory_map = {{"Z2", 0, 20}, {"stack", 20, 4}};
  const std::vector<plots::Plot> all = studies::plots_of_sweep(rows, "a");
  const auto memory = std::ranges::find(all, "a_memory", &plots::Plot::name);
  REQUIRE(memory != all.end());
  const auto& bars = std::get<plots::Bars>(memory->content).bars;
  REQUIRE(bars.size() == 3);
  CHECK(bars[0].name.find("list") != std::string::npos);
  CHECK(bars[0].length == 72);
  CHECK(bars[1].length == 96);
  CHECK(bars[1].parts.size() == 1);
  CHECK(bars[2].length == 72);
  CHECK(bars[2].parts.size() == 2);
}

TEST_CASE("points of a sweep that cannot be compiled are in no plot") {
  std::vector<studies::SweepRow> rows{row(point("stack", 0), 7), row(point("bits", 3), 0)};
  rows[1].reason = "does not fit";
  const plots::Chart chart = chart_named(studies::plots_of_sweep(rows, "a"), "a_clocks");
  for (const plots::Series& series : chart.series) {
    for (const plots::Point& one : series.points) CHECK(one.y == 7);
  }
  rows[0].reason = "does not fit";
  CHECK(studies::plots_of_sweep(rows, "a").empty());
}

TEST_CASE("values of a setting are placed along the x axis by size") {
  std::vector<studies::Measurement> rows(5);
  const Words values{"1/4", "1/16", "128x64", "0.125", "12"};
  const Words knobs{"edge-on", "edge-on", "size", "tolerance", "z-bits"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].knob = knobs[i];
    rows[i].value = values[i];
    rows[i].clocks = 100 + i;
    rows[i].wrong = i;
  }
  const std::vector<plots::Plot> all = studies::plots_of_accuracy(rows, {"a", 4});
  const plots::Chart edge_on = chart_named(all, "edge-on");
  CHECK(edge_on.panels.size() == 3);
  REQUIRE(edge_on.series[0].points.size() == 2);
  CHECK(edge_on.series[0].points[0].x == 0.0625);
  CHECK(edge_on.series[0].points[0].y == 1);
  CHECK(edge_on.series[2].points[0].y == 101);
  CHECK(tick_texts(edge_on.x) == Words{"1/4", "1/16"});
  CHECK(chart_named(all, "size").series[0].points[0].x == 128);
  CHECK(chart_named(all, "tolerance").series[0].points[0].x == 0.125);
  CHECK(chart_named(all, "z-bits").series[0].points[0].x == 12);
}

TEST_CASE("facets and curves share a plot of clocks and pixels off the true surface") {
  std::vector<studies::Measurement> rows(5);
  const Words knobs{"tolerance", "tolerance", "fn", "curves", "curves"};
  const Words values{"0.1", "0.5", "16", "facets", "exact"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].knob = knobs[i];
    rows[i].value = values[i];
    rows[i].clocks = 100 - i;
    rows[i].facet_wrong = 10 * i;
    rows[i].wrong = 7;
  }
  const plots::Chart chart = chart_named(studies::plots_of_accuracy(rows, {"a", 4}), "curves");
  REQUIRE(chart.series.size() == 4);
  CHECK(chart.series[0].name == "facets, by tolerance");
  CHECK(chart.series[0].points.front().label == "0.5");
  CHECK(chart.series[0].points.front().x == 99);
  CHECK(chart.series[0].points.front().y == 10);
  CHECK(chart.series[1].points.front().label == "16");
  CHECK(chart.series[2].name == "facets, as modelled");
  CHECK(chart.series[3].name == "exact curves");
  CHECK(chart.series[3].points.front().x == 96);
  CHECK(chart.series[3].points.front().y == 40);
}

TEST_CASE("a comparison has a plot each for varied machines and half-spaces and pixels") {
  std::vector<studies::ComparisonRow> rows(2);
  for (studies::ComparisonRow& one : rows) {
    one.point = {"scan-line", 64, 64, 0, {}};
    one.simulated_seconds = 0.5;
    one.frames_per_second = 2;
    one.halfspaces = 100;
  }
  rows[1].point.machine = "pixel-square";
  const auto names = [&] {
    Words words;
    for (const plots::Plot& plot : studies::plots_of_comparison(rows, {64, 64}, "a")) words.push_back(plot.name);
    return words;
  };
  CHECK(names() == Words{"compare_machines"});
  rows.push_back(rows[0]);
  rows.back().point.fragments = 8;
  rows.back().halfspaces = 200;
  CHECK(names() == Words{"compare_machines", "compare_halfspaces"});
  rows.push_back(rows[0]);
  rows.back().point.width = 128;
  CHECK(names() == Words{"compare_machines", "compare_halfspaces", "compare_pixels"});
}

TEST_CASE("machines of a comparison that differ in a parameter are named by the parameter") {
  std::vector<studies::ComparisonRow> rows(3);
  const Words machines{"pixel-planes-4", "pixel-planes-4+alu.bits=2", "pixel-planes-4+alu.bits=2+array.memory_bits=96"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].point = {machines[i], 64, 64, 0, {}};
    rows[i].frames_per_second = 1;
    rows[i].machine_transistors = 100 + i;
  }
  const plots::Chart chart = chart_named(studies::plots_of_comparison(rows, {64, 64}, "a"), "compare_machines");
  CHECK(tick_texts(chart.x) == Words{"pixel-planes-4", "+alu.bits=2", "+array.memory_bits=96"});
  REQUIRE(chart.panels.size() == 4);
  CHECK(chart.series[3].points[2].y == 102);
  rows[1].machine_transistors.reset();
  CHECK(chart_named(studies::plots_of_comparison(rows, {64, 64}, "a"), "compare_machines").panels.size() == 3);
}

TEST_CASE("a comparison shows the frame interval first and the drawing time next to it") {
  std::vector<studies::ComparisonRow> rows(4);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].point = {i % 2 == 0 ? "pixel-planes-4" : "pixel-square", 64, 64, i < 2 ? 0.0 : 8.0, {}};
    rows[i].halfspaces = i < 2 ? 100 : 50;
  }
  // The first draws faster but has the longer frame interval.
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].simulated_seconds = i % 2 == 0 ? 0.003 : 0.004;
    rows[i].frames_per_second = i % 2 == 0 ? 64 : 200;
  }
  const std::vector<plots::Plot> all = studies::plots_of_comparison(rows, {64, 64}, "a");
  const plots::Chart machines = chart_named(all, "compare_machines");
  CHECK(machines.panels[0].title == "time between frames, ms");
  CHECK(machines.panels[1].title == "drawing time, ms");
  CHECK(machines.series[0].points[0].y == 1000.0 / 64);
  CHECK(machines.series[0].points[1].y == 5);
  CHECK(machines.series[1].points[0].y == 3);
  CHECK(machines.series[1].points[1].y == 4);
  const plots::Chart growth = chart_named(all, "compare_halfspaces");
  CHECK(growth.panels[0].title == "time between frames, ms");
  CHECK(growth.panels[1].title == "drawing time, ms");
  REQUIRE(growth.series.size() == 4);
  for (const plots::Series& series : growth.series) {
    const bool is_planes = series.name == "pixel-planes-4";
    CHECK(series.points[0].y == (series.panel == 0 ? (is_planes ? 1000.0 / 64 : 5.0) : (is_planes ? 3.0 : 4.0)));
  }
}

TEST_CASE("the plots of corpus show frame intervals first and share the looks of series") {
  std::vector<studies::CorpusRow> rows(2);
  rows[0].point = {"a.csg", "pixel-planes-4"};
  rows[1].point = {"a.csg", "pixel-square"};
  for (studies::CorpusRow& row : rows) {
    row.halfspaces = 10;
    row.clocks = 300;
    row.interval_clocks = 1500;
    row.frames_per_second = 7;
  }
  const std::vector<plots::Plot> all = studies::plots_of_corpus(rows);
  const plots::Chart clocks = chart_named(all, "corpus_clocks");
  REQUIRE(clocks.panels.size() == 2);
  CHECK(clocks.panels[0].title == "clocks between frames");
  CHECK(clocks.panels[1].title == "drawing clocks");
  REQUIRE(clocks.series.size() == 4);
  for (const plots::Series& series : clocks.series) CHECK(series.points[0].y == (series.panel == 0 ? 1500 : 300));
  CHECK(!clocks.looks.empty());
  CHECK(clocks.looks == chart_named(all, "corpus_frames").looks);
}

TEST_CASE("the axes of accuracy's plots distinguish sums over views from percentiles") {
  std::vector<studies::Measurement> rows(4);
  const Words knobs{"z-bits", "together", "curves", "tolerance"};
  const Words values{"12", "12/4", "facets", "0.1"};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    rows[i].knob = knobs[i];
    rows[i].value = values[i];
    rows[i].clocks = 100;
  }
  const std::vector<plots::Plot> all = studies::plots_of_accuracy(rows, {"a", 4});
  const plots::Chart z_bits = chart_named(all, "z-bits");
  CHECK(z_bits.panels[0].title == "wrong pixels, sum of 4 views");
  CHECK(z_bits.panels[1].title == "depth error (p99.9), model units");
  CHECK(z_bits.panels[2].title == "clocks, sum of 4 views");
  for (const char* name : {"pareto", "curves"}) {
    const plots::Chart chart = chart_named(all, name);
    CHECK(chart.x.title == "clocks, sum of 4 views");
    CHECK(chart.panels[0].title.ends_with(", sum of 4 views"));
  }
  const plots::Chart alone = chart_named(studies::plots_of_accuracy(rows, {"a", 1}), "z-bits");
  CHECK(alone.panels[0].title == "wrong pixels");
  CHECK(alone.panels[2].title == "clocks");
}
