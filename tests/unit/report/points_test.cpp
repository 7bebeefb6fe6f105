#include "sim/report/points.h"

#include <doctest/doctest.h>

#include <glm/vec2.hpp>
#include <regex>
#include <string>
#include <vector>

#include "sim/report/number_text.h"
#include "sim/report/plot_svg.h"

using namespace csgsim;
using report::Json;

namespace {

Json point(const char* line, double x, double y) { return {{"line", line}, {"x", x}, {"y", y}}; }

std::vector<report::Series> series_of(const std::vector<Json>& points) {
  const auto line = [](const Json& one) { return one.at("line").get<std::string>(); };
  return report::series_of(points, {report::number_at("x"), report::number_at("y"), line});
}

}  // namespace

TEST_CASE("a number that rounds to 1,000 or more is told in groups, and a smaller one to four digits") {
  CHECK(report::number_text(999.4) == "999.4");
  for (const double value : {999.5, 999.7, 1000.3}) CHECK(report::number_text(value) == "1,000");
  CHECK(report::number_text(-999.5) == "-1,000");
}

TEST_CASE("lines that are alike in one coordinate only stay apart, and those alike in both are one") {
  const std::vector<Json> first{point("a", 1, 10), point("a", 2, 20)};
  const auto beside = [&](double x1, double y1, double x2, double y2) {
    std::vector<Json> points = first;
    points.push_back(point("b", x1, y1));
    points.push_back(point("b", x2, y2));
    return series_of(points);
  };
  CHECK(beside(1, 11, 2, 21).size() == 2);
  CHECK(beside(3, 10, 4, 20).size() == 2);
  const std::vector<report::Series> alike = beside(1, 10, 2, 20);
  REQUIRE(alike.size() == 1);
  CHECK(alike.front().name == "a (+ 1 alike)");
}

TEST_CASE("a ninth line of a plot has the first one's colour and other dashes") {
  report::Plot plot{"title", {"x"}, {"y"}, {}};
  for (int i = 0; i < 9; ++i) plot.series.push_back({"line " + std::to_string(i), {{0, 1.0 * i}, {1, 1.0 * i}}});
  const std::string html = report::plot_html(plot, "id");
  CHECK(html.find("\"series s0 d0\"") != std::string::npos);
  CHECK(html.find("\"series s7 d7\"") != std::string::npos);
  CHECK(html.find("\"series s0 d1\"") != std::string::npos);
}

TEST_CASE("points stand in the frame as their values do, upwards and to the right") {
  const report::Plot plot{"title", {"x"}, {"y"}, {{"line", {{0, 0}, {1, 3}, {4, 4}}}}};
  const std::string html = report::plot_html(plot, "id");
  const std::regex axis("<path class=axis d=\"M([0-9.]+) ([0-9.]+)V([0-9.]+)H([0-9.]+)\"/>");
  std::smatch frame;
  REQUIRE(std::regex_search(html, frame, axis));
  const double height = std::stod(frame[3]) - std::stod(frame[2]);
  const double width = std::stod(frame[4]) - std::stod(frame[1]);
  const std::regex mark("<use href=\"#m[0-9]+\" x=([0-9.]+) y=([0-9.]+) />");
  std::vector<glm::dvec2> places;
  for (auto found = std::sregex_iterator(html.begin(), html.end(), mark); found != std::sregex_iterator(); ++found)
    places.emplace_back(std::stod((*found)[1]), std::stod((*found)[2]));
  REQUIRE(places.size() >= 3);
  const glm::dvec2 first = places[1] - places[0];
  const glm::dvec2 second = places[2] - places[1];
  CHECK(first.x > width / 8);
  CHECK(first.y < -height / 2);
  CHECK(second.x == doctest::Approx(3 * first.x).epsilon(0.01));
  CHECK(first.y == doctest::Approx(3 * second.y).epsilon(0.01));
  // The lines of 4, across and up, go through the point at 4,4.
  std::smatch tick;
  REQUIRE(std::regex_search(html, tick, std::regex("d=\"M([0-9.-]+) [0-9.]+V[0-9.]+\"/><text [^>]*>4<")));
  CHECK(std::stod(tick[1]) == doctest::Approx(places[2].x));
  REQUIRE(std::regex_search(html, tick, std::regex("d=\"M[0-9.]+ ([0-9.-]+)H[0-9.]+\"/><text [^>]*>4<")));
  CHECK(std::stod(tick[1]) == doctest::Approx(places[2].y));
}

TEST_CASE("lines of one name look alike in all plots of a page, whatever else is in them") {
  const auto plot_of = [](const std::vector<std::string>& names) {
    report::Plot plot{"title", {"x"}, {"y"}, {}};
    for (const std::string& name : names) plot.series.push_back({name, {{0, 1}, {1, 2}}});
    return plot;
  };
  report::Page page;
  page.sections.push_back({"Plots", {plot_of({"a", "b", "c"}), plot_of({"c", "a"})}});
  const plots::Looks looks = report::page_looks(page);
  CHECK(looks.at("a") == 0);
  CHECK(looks.at("c") == 2);
  const std::string html = report::to_html(page);
  const std::size_t second = html.find("id=plot-2");
  REQUIRE(second != std::string::npos);
  CHECK(html.find("\"series s2 d2\"", second) < html.find("\"series s0 d0\"", second));
  CHECK(html.find("\"series s1 d1\"", second) == std::string::npos);
}
