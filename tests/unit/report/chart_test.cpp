#include "sim/report/chart.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "sim/plots/palette.h"

using namespace csgsim;

namespace {

std::string html_of(const report::Section& section) {
  return report::to_html({"t", "c", report::Json::object(), {section}});
}

const std::vector<plots::Point> points{{0, 0}, {5, 10}, {10, 20}};

plots::Chart chart(plots::Trace trace) { return {"title", {"x"}, {{"y"}}, {{"one", 0, trace, points}}, "t.csv"}; }

/// The path that joins the points of the wide picture.
std::string path_of(plots::Trace trace, bool is_backward = false) {
  plots::Chart shown = chart(trace);
  if (is_backward) std::ranges::reverse(shown.series.front().points);
  const plots::Plot plot{"name", shown};
  const std::string html = html_of(report::plots_section({&plot, 1}));
  const std::string begin = "<path class=line d=\"";
  const std::size_t at = html.find(begin);
  if (at == std::string::npos) return "";
  return html.substr(at + begin.size(), html.find('"', at + begin.size()) - at - begin.size());
}

}  // namespace

TEST_CASE(
    "the traces of a chart are lines, steps that hold until the next point and then to the edge, levels, uprights, "
    "marks") {
  const auto count = [](const std::string& path, char what) { return std::count(path.begin(), path.end(), what); };
  const std::string line = path_of(plots::Trace::line);
  CHECK(count(line, 'L') == 2);
  const std::string steps = path_of(plots::Trace::steps);
  CHECK(count(steps, 'V') == 2);
  CHECK(count(steps, 'H') == 3);
  // To the right where x grows, to the left where it falls.
  const std::string backward = path_of(plots::Trace::steps, true);
  const auto end = [](const std::string& path) { return std::stod(path.substr(path.rfind('H') + 1)); };
  CHECK(end(steps) > 500);
  CHECK(end(backward) < 100);
  CHECK(path_of(plots::Trace::marks) == "");
  const std::string level = path_of(plots::Trace::level);
  CHECK(level.substr(0, 1) == "M");
  CHECK(count(level, 'H') == 1);
  CHECK(count(level, 'V') == 0);
  const std::string upright = path_of(plots::Trace::upright);
  CHECK(count(upright, 'H') == 0);
  CHECK(count(upright, 'V') == 1);
}

TEST_CASE("a chart of two panels is two plots, each of its own series; what is not finite is left out") {
  plots::Chart two = chart(plots::Trace::line);
  two.panels.push_back({"z", plots::Scale::logarithmic});
  two.series.push_back({"other", 1, plots::Trace::marks, {{1, 2, "label"}, {2, std::nan("")}}});
  const std::vector<report::Plot> plots = report::page_plots(two);
  REQUIRE(plots.size() == 2);
  CHECK(plots[0].y.title == "y");
  CHECK(plots[0].series.front().name == "one");
  CHECK_FALSE(plots[0].y.logarithmic);
  CHECK(plots[1].y.title == "z");
  CHECK(plots[1].y.logarithmic);
  REQUIRE(plots[1].series.front().points.size() == 1);
  CHECK(plots[1].series.front().points.front().label == "label");
}

TEST_CASE("an axis by range is logarithmic where its values range over a factor of 20, and names are words") {
  plots::Chart wide = chart(plots::Trace::line);
  wide.series.front().points = {{0, 1}, {1, 20}};
  wide.x = {"x", plots::Scale::linear, {{0, "a"}, {1, "b"}}, true};
  CHECK(report::page_plots(wide).front().y.logarithmic);
  CHECK(report::page_plots(wide).front().x.names == std::vector<std::string>{"a", "b"});
  wide.series.front().points.back().y = 19;
  CHECK_FALSE(report::page_plots(wide).front().y.logarithmic);
  wide.series.front().points = {{0, -1}, {1, 20}};
  CHECK_FALSE(report::page_plots(wide).front().y.logarithmic);
}

TEST_CASE("series have the colours of plots in files, and others on a dark page") {
  const std::string html = html_of({"s", {}});
  const std::size_t dark = html.find("@media (prefers-color-scheme:dark){:root{--s0");
  REQUIRE(dark != std::string::npos);
  for (std::size_t i = 0; i < plots::palette::looks.size(); ++i) {
    const std::string name = "--s" + std::to_string(i) + ":";
    CHECK(html.find(name + std::string(plots::palette::looks[i].colour)) < dark);
    CHECK(html.find(name + std::string(plots::palette::colours_on_dark[i]), dark) != std::string::npos);
  }
  CHECK(html.find(".d1 .line{stroke-dasharray:8 3}") != std::string::npos);
}
