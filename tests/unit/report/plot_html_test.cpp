#include <doctest/doctest.h>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>

#include "sim/plots/common_looks.h"
#include "sim/plots/layout.h"
#include "sim/plots/palette.h"
#include "sim/plots/svg.h"
#include "sim/report/page.h"
#include "sim/report/parts_html.h"
#include "sim/report/study_pages.h"

using namespace csgsim;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

plots::Plot make_chart(const std::vector<std::string>& names) {
  plots::Chart chart{"title", {"x"}, {{"y"}}, {}, "t.csv"};
  for (const std::string& name : names)
    chart.series.push_back({name, 0, plots::Trace::line, {{0, 1}, {1, 2.5, "point of " + name}}});
  return {"name", std::move(chart)};
}

const plots::Plot bars{
    "bars", plots::Bars{"which bits", {"bit"}, {{"stack", 72, {{"Z2", 0, 20}, {"Z1", 20, 40}}}}, {}, "t.csv"}};

/// Returns the contents of a drawing's SVG file without the root's attributes.
std::string content_of_file(const plots::Plot& plot) {
  const std::string file = plots::svg_file(plots::lay_out(plot));
  return file.substr(file.find('\n'));
}

}  // namespace

TEST_CASE("a page draws a plot identically to its SVG file") {
  for (const plots::Plot& plot : {make_chart({"one", "other"}), bars}) {
    const std::string html = report::plot_html(plot);
    CHECK(content_of_file(plot).size() > 1000);
    CHECK(html.find(content_of_file(plot)) != std::string::npos);
    const report::Page page{"t", "c", report::Json::object(), {report::plots_section({&plot, 1})}};
    CHECK(report::to_html(page).find(html) != std::string::npos);
  }
}

TEST_CASE("a plot has a text alternative and tips and a table of values") {
  const std::string html = report::plot_html(make_chart({"a < b"}));
  CHECK(html.find("role=\"img\" aria-label=\"title: y against x; the table below has its values\"") !=
        std::string::npos);
  CHECK(html.find("<title>a &lt; b: x 0, y 1</title>") != std::string::npos);
  CHECK(html.find("<title>a &lt; b, point of a &lt; b: x 1, y 2.5</title>") != std::string::npos);
  CHECK(html.find("<td class=n>2.5</td><td>point of a &lt; b</td>") != std::string::npos);
  const std::string of_bars = report::plot_html(bars);
  CHECK(of_bars.find("aria-label=\"which bits: bit; the table") != std::string::npos);
  CHECK(of_bars.find("<title>stack: Z1, bit 20 to 40</title>") != std::string::npos);
  CHECK(of_bars.find("<th scope=row>stack</th><td>Z1</td><td class=n title=\"20.0\">20</td>") != std::string::npos);
}

TEST_CASE("each panel of a chart has a table of its series without non-finite values") {
  plots::Plot two = make_chart({"one"});
  auto& chart = std::get<plots::Chart>(two.content);
  chart.panels.push_back({"z", plots::Scale::logarithmic});
  chart.series.push_back({"other", 1, plots::Trace::marks, {{1, 2, "label"}, {2, std::nan("")}, {INFINITY, 1}}});
  const std::string html = report::plot_html(two);
  CHECK(html.find("title: y, z against x") != std::string::npos);
  CHECK(count(html, "<caption>y</caption>") == 1);
  CHECK(count(html, "<caption>z</caption>") == 1);
  CHECK(count(html, ">other</th>") == 1);
  CHECK(count(html, "<title>") == 3);
}

TEST_CASE("a plot's table has the names of a named axis instead of numbers") {
  plots::Plot plot = make_chart({"one"});
  std::get<plots::Chart>(plot.content).x = {"machine", plots::Scale::linear, {{0, "first"}, {1, "second"}}, true};
  const std::string html = report::plot_html(plot);
  CHECK(html.find("<th scope=row>one</th><td>second</td><td class=n>2.5</td>") != std::string::npos);
  CHECK(html.find("machine second, y 2.5") != std::string::npos);
}

TEST_CASE("a plot of too many lines has a note and lists all values") {
  std::vector<std::string> names;
  names.reserve(15);
  for (int i = 0; i < 15; ++i) names.push_back("line " + std::to_string(i) + ";");
  const std::string html = report::plot_html(make_chart(names));
  CHECK(html.find("7 more, with smaller values (see t.csv)") != std::string::npos);
  CHECK(count(html, "<th scope=row>line 14;</th>") == 2);
  CHECK(count(html, "<g class=\"pt\">") == 2 * 15);
}

TEST_CASE("a section of a page omits empty plots") {
  const std::array all{make_chart({"one"}), make_chart({}), bars, plots::Plot{"none", plots::Bars{}}};
  const report::Section section = report::plots_section(all);
  REQUIRE(section.parts.size() == 2);
  CHECK(std::get<plots::Plot>(section.parts[0]).name == "name");
  CHECK(std::get<plots::Plot>(section.parts[1]).name == "bars");
}

TEST_CASE("lines with the same name look alike in all plots of a page") {
  std::vector<plots::Plot> plots{make_chart({"a", "b", "c"}), make_chart({"c", "a"})};
  plots::set_common_looks(plots);
  const auto colour_of = [](const std::string& html, const std::string& name) {
    const std::size_t at = html.find("<title>" + name + ": ");
    const std::size_t fill = html.find("fill=\"", at) + 6;
    return html.substr(fill, html.find('"', fill) - fill);
  };
  const std::string first = report::plot_html(plots[0]);
  const std::string second = report::plot_html(plots[1]);
  CHECK(colour_of(first, "a") == plots::palette::looks[0].colour);
  CHECK(colour_of(second, "a") == plots::palette::looks[0].colour);
  CHECK(colour_of(second, "c") == colour_of(first, "c"));
  CHECK(colour_of(first, "b") != colour_of(first, "c"));
}

TEST_CASE("series have the colours of plot files and other colours on a dark page") {
  const std::string html = report::to_html({"t", "c", report::Json::object(), {}});
  const std::size_t dark = html.find("@media (prefers-color-scheme:dark){:root{--s0");
  REQUIRE(dark != std::string::npos);
  for (std::size_t i = 0; i < plots::palette::looks.size(); ++i) {
    const std::string_view colour = plots::palette::looks[i].colour;
    CHECK(html.find(fmt::format("--s{}:{};", i, colour)) < dark);
    CHECK(html.find(fmt::format("--s{}:{};", i, plots::palette::colours_on_dark[i]), dark) != std::string::npos);
    for (const std::string_view paint : {"fill", "stroke"})
      CHECK(html.find(fmt::format(".plot [{0}=\"{1}\"]{{{0}:var(--s{2})}}", paint, colour, i)) != std::string::npos);
  }
}