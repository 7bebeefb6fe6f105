#include "sim/report/page.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "sim/report/study_pages.h"
#include "sim/report/table_html.h"

using namespace csgsim;
using report::Json;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

report::Page page(const std::string& name) {
  report::Page page{name, "csgsim render '" + name + "'", {{"name", name}, {"clocks", 1234567}}, {}};
  report::Table table{name, {name, "clocks"}, {{{name}, report::cell(page.data, "/clocks")}}};
  const report::Plot plot{name, {name}, {name}, {{name, {{1, 2, name}, {3, 4, name}}}}};
  page.sections.push_back({name, {report::Paragraph{name}, table, plot}});
  return page;
}

}  // namespace

TEST_CASE("a hostile name is nowhere markup, and ends no script") {
  const std::string plain = report::to_html(page("plain"));
  for (const std::string name : {"</script><script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "<!-- ",
                                 "]]></style></title><b>", "' onload='x"}) {
    const std::string html = report::to_html(page(name));
    for (const std::string tag : {"<script", "</script", "<img", "<!--", "<b>", "</style", "</title"})
      CHECK(count(html, tag) == count(plain, tag));
    if (name.find('<') != std::string::npos) CHECK(html.find(name) == std::string::npos);
  }
}

TEST_CASE("a cell shows the number of the data, and says where it stands there") {
  const Json data{{"clocks", 1234567}, {"share", 0.123456}, {"words", "a & b"}};
  const auto cells = [&](const report::Cell& cell) { return report::table_html({"", {"a"}, {{cell}}}); };
  CHECK(cells(report::cell(data, "/clocks")).find("data-at=\"/clocks\">1,234,567<") != std::string::npos);
  CHECK(cells(report::cell(data, "/share")).find("title=\"0.123456\">0.1235<") != std::string::npos);
  CHECK(cells(report::cell(data, "/share", report::Show::share)).find("12.3 %") != std::string::npos);
  CHECK(cells(report::cell(data, "/words")).find("a &amp; b") != std::string::npos);
  CHECK(report::cell(data, "/none").value.is_null());
}

TEST_CASE("the data of a page are those of the run, but for the times that it took here") {
  const Json data{{"clocks", 5}, {"wall_seconds", 1.5}, {"rows", {{{"bits", 1}, {"wall_seconds", 2.5}}}}};
  CHECK(report::without_wall_times(data) == Json{{"clocks", 5}, {"rows", {{{"bits", 1}}}}});
}

TEST_CASE("a plot of more lines than can be told apart says so, and its values are all there") {
  report::Plot plot{"title", {"x"}, {"y"}, {}};
  for (int i = 0; i < 15; ++i) plot.series.push_back({"line " + std::to_string(i) + ";", {{1.0 * i, 2}}});
  const std::string html = report::to_html({"t", "c", Json::object(), {{"s", {plot}}}});
  CHECK(html.find("The first 12 of 15 lines") != std::string::npos);
  CHECK(count(html, ">line 14;<") == 1);
  CHECK(count(html, "<g class=pt>") == 2 * 12);
}

TEST_CASE("a sweep's page has a line a strategy, joins those that are alike, and says why a point is none") {
  const auto point = [](const std::string& strategy, int bits, int clocks) {
    return Json{{"model", "folder/a.csg"},
                {"machine", "m"},
                {"memory_bits", 72},
                {"z_bits", 20},
                {"pruning", "all"},
                {"colouring", "field"},
                {"strategy", strategy},
                {"stack_bits", 0},
                {"clocks", clocks},
                {"rendered", 3},
                {"classified", 4},
                {"depth_tests", 3},
                {"classification_bits", bits},
                {"used_bits", 40},
                {"reason", ""}};
  };
  Json failed{{"model", "folder/a.csg"}, {"strategy", "bits"}, {"reason", "no <room>"}};
  for (const char* const key : {"machine", "memory_bits", "z_bits", "pruning", "colouring", "stack_bits"})
    failed[key] = point("bits", 1, 1)[key];
  const Json file{{"study", "s"}, {"points", {point("stack", 2, 100), point("list", 2, 100), failed}}};
  const std::string html = report::to_html(report::sweep_page(file, {{"csgsim sweep", {}}, "a.csg", {}, "too dark"}));
  CHECK(html.find("stack (+ 1 alike)") != std::string::npos);
  CHECK(html.find("no &lt;room&gt;") != std::string::npos);
  CHECK(html.find("There is no picture: too dark") != std::string::npos);
  CHECK(html.find("a.csg: what memory buys") != std::string::npos);
}

TEST_CASE("sentences and tables that other versions of the stats tell are shown where they are there") {
  const Json data{{"knobs", {{{"sentence", "Turn this."}}, {{"sentence", "Or that."}}}},
                  {"configuration", {{"model", {{"file", "m.csg"}}}, {"bits", {1, 2}}, {"unsaid", nullptr}}}};
  const std::vector<report::Part> parts = report::sentences(data, "/knobs");
  REQUIRE(parts.size() == 2);
  CHECK(std::get<report::Paragraph>(parts[1]).text == "Or that.");
  const report::Section section = report::configuration_section(data, {"c", {{"--unused", "1"}}});
  const std::string html = report::table_html(std::get<report::Table>(section.parts.front()));
  CHECK(html.find("data-at=\"/configuration/model/file\">m.csg<") != std::string::npos);
  CHECK(html.find(">1, 2<") != std::string::npos);
  CHECK(html.find("unsaid") == std::string::npos);
}

TEST_CASE("a study's configuration is its options and the figures of its machines, with what they are from") {
  const Json machine{{"name", "m"},
                     {"figures", {{"clock.hz", {{"value", 5}, {"unit", "Hz"}, {"provenance", "assumed"}}}}}};
  const report::Section section = report::configuration_section(Json::object(), {"c", {{"--size", "8x8"}}, {machine}});
  REQUIRE(section.parts.size() == 2);
  const std::string html = report::table_html(std::get<report::Table>(section.parts[1]));
  for (const std::string part : {"Figures of m", ">clock.hz<", ">5<", ">Hz<", ">assumed<"})
    CHECK(html.find(part) != std::string::npos);
  CHECK(report::table_html(std::get<report::Table>(section.parts[0])).find(">8x8<") != std::string::npos);
}
