#include "sim/report/page.h"

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "sim/report/parts_html.h"
#include "sim/report/points.h"
#include "sim/report/study_pages.h"

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
  const plots::Plot plot{
      name, plots::Chart{name, {name}, {{name}}, {{name, 0, plots::Trace::line, {{1, 2, name}, {3, 4, name}}}}, name}};
  const plots::Plot bars{name, plots::Bars{name, {name}, {{name, 8, {{name, 0, 4}}}}, {name}, name}};
  page.sections.push_back({name, {report::Paragraph{name}, table, plot, bars}});
  return page;
}

}  // namespace

TEST_CASE("a hostile name in a page is never markup and ends no script") {
  const std::string plain = report::to_html(page("plain"));
  for (const std::string name : {"</script><script>alert(1)</script>", "\"><img src=x onerror=alert(1)>", "<!-- ",
                                 "]]></style></title><b>", "' onload='x"}) {
    const std::string html = report::to_html(page(name));
    for (const std::string tag : {"<script", "</script", "<img", "<!--", "<b>", "</style", "</title"})
      CHECK(count(html, tag) == count(plain, tag));
    if (name.find('<') != std::string::npos) CHECK(html.find(name) == std::string::npos);
  }
}

TEST_CASE("a table cell shows a value of the page's data and its JSON path") {
  const Json data{{"clocks", 1234567}, {"share", 0.123456}, {"words", "a & b"}};
  const auto cells = [&](const report::Cell& cell) { return report::table_html({"", {"a"}, {{cell}}}); };
  CHECK(cells(report::cell(data, "/clocks")).find("data-at=\"/clocks\">1,234,567<") != std::string::npos);
  CHECK(cells(report::cell(data, "/share")).find("title=\"0.123456\">0.1235<") != std::string::npos);
  CHECK(cells(report::cell(data, "/share", report::Show::share)).find("12.3 %") != std::string::npos);
  CHECK(cells(report::cell(data, "/words")).find("a &amp; b") != std::string::npos);
  CHECK(report::cell(data, "/none").value.is_null());
}

TEST_CASE("a share in a page is a fraction or 0 for 0 of 0 or absent for a missing number") {
  CHECK(report::share(3, 12).value == 0.25);
  CHECK(report::share(0, 0).value == 0.0);
  CHECK(report::share(nullptr, 12).value.is_null());
}

TEST_CASE("without_wall_times() removes wall-clock times at every level of a page's data") {
  const Json data{{"clocks", 5}, {"wall_seconds", 1.5}, {"rows", {{{"bits", 1}, {"wall_seconds", 2.5}}}}};
  CHECK(report::without_wall_times(data) == Json{{"clocks", 5}, {"rows", {{{"bits", 1}}}}});
}

TEST_CASE("a study's page states why a point or the picture is missing") {
  const Json file{
      {"points",
       {{{"strategy", "stack"}, {"clocks", 100}, {"reason", ""}}, {{"strategy", "bits"}, {"reason", "no <room>"}}}}};
  constexpr report::PointColumn columns[] = {{"strategy", "strategy"}, {"clocks", "clocks"}, {"bits", "bits"}};
  report::Page page = report::begin_page("title", file, {{"csgsim sweep", {}}, "a.csg", {}, "too dark"});
  page.sections.push_back({"Points", {report::points_table(page.data, "/points", "All", columns)}});
  const std::string html = report::to_html(page);
  CHECK(html.find("<th scope=col>reason</th>") != std::string::npos);
  CHECK(html.find("no &lt;room&gt;") != std::string::npos);
  CHECK(count(html, ">bits</th>") == 1);  // the second row's header; no point has a value for a column of bits
  CHECK(html.find("No picture: too dark") != std::string::npos);
}

TEST_CASE("the effects page plots a mark for each charge of each effect") {
  const Json flat{{"effect", "flat"}, {"clocks", 51251}};
  const Json fog{{"effect", "fog"}, {"clocks", 1719}, {"alone_clocks", 1743}, {"together_clocks", 1743}};
  const std::string html = report::to_html(report::effects_page({{"effects", {flat, fog}}}, {}, {}));
  for (const std::string tip :
       {"charged: effect flat, clocks 51,251", "charged: effect fog, clocks 1,719",
        "added alone: effect fog, clocks 1,743", "saved without the effect: effect fog, clocks 1,743"})
    CHECK(count(html, "<title>" + tip + "</title>") == 1);
  CHECK(count(html, "<g class=\"pt\">") == 4);
}

TEST_CASE("a page shows advice sentences and configuration values but no null values") {
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

TEST_CASE("a study's configuration lists its options and its machines' sourced parameters") {
  const Json machine{{"name", "m"},
                     {"figures", {{"clock.hz", {{"value", 5}, {"unit", "Hz"}, {"provenance", "assumed"}}}}}};
  const report::Section section = report::configuration_section(Json::object(), {"c", {{"--size", "8x8"}}, {machine}});
  REQUIRE(section.parts.size() == 2);
  const std::string html = report::table_html(std::get<report::Table>(section.parts[1]));
  for (const std::string part : {"Parameters of m", ">clock.hz<", ">5<", ">Hz<", ">assumed<"})
    CHECK(html.find(part) != std::string::npos);
  CHECK(report::table_html(std::get<report::Table>(section.parts[0])).find(">8x8<") != std::string::npos);
}