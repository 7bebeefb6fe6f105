#include "sim/plots/common_looks.h"

#include "sim/plots/chart_series.h"
#include "sim/plots/palette.h"
#include "tests/support/test.h"

using namespace csgsim;

namespace {

plots::Plot make_chart(const std::string& plot, const plots::Names& names) {
  plots::Chart chart{"title", {"across"}, {{"up"}}, {}, "table.csv"};
  double height = 100;
  for (const std::string& name : names) chart.series.push_back({name, 0, plots::Trace::line, {{0, --height}}});
  return {plot, std::move(chart)};
}

/// Returns the look of a series in a plot.
plots::palette::Look look_in(const plots::Plot& plot, const std::string& name) {
  const auto& chart = std::get<plots::Chart>(plot.content);
  const plots::SeriesLooks looks = plots::series_looks(chart);
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    if (chart.series[i].name == name) return looks.looks[i];
  }
  FAIL("the plot has no such series");
  return {};
}

plots::Names numbered(const std::string& stem, int count) {
  plots::Names names;
  for (int i = 0; i < count; ++i) names.push_back(stem + std::to_string(i));
  return names;
}

}  // namespace

TEST_CASE("a series has the same colour and mark in all plots of a study") {
  std::vector<plots::Plot> plots{make_chart("one", {"a", "b", "c"}), make_chart("other", {"c", "d", "a"})};
  plots::set_common_looks(plots);
  std::set<std::string_view> colours;
  for (const char* name : {"a", "c"}) {
    const plots::palette::Look look = look_in(plots[0], name);
    CHECK(look.colour == look_in(plots[1], name).colour);
    CHECK(look.mark == look_in(plots[1], name).mark);
    colours.insert(look.colour);
  }
  colours.insert(look_in(plots[0], "b").colour);
  colours.insert(look_in(plots[1], "d").colour);
  CHECK(colours.size() == 4);
}

TEST_CASE("plots with more names than colours reuse colours but never within one plot") {
  std::vector<plots::Plot> plots{make_chart("one", numbered("a", 5)), make_chart("other", numbered("b", 7))};
  plots::set_common_looks(plots);
  for (const plots::Plot& plot : plots) {
    std::set<std::string_view> colours;
    const auto& chart = std::get<plots::Chart>(plot.content);
    for (const plots::Series& series : chart.series) colours.insert(look_in(plot, series.name).colour);
    CHECK(colours.size() == chart.series.size());
    CHECK(!colours.contains(plots::palette::background.colour));
  }
}

TEST_CASE("an unnamed series gets a colour that no named series of another plot has") {
  std::vector<plots::Plot> plots{make_chart("one", {""}), make_chart("other", {"a", "b"})};
  plots::set_common_looks(plots);
  CHECK(look_in(plots[1], "a").colour == plots::palette::looks[0].colour);
  CHECK(look_in(plots[0], "").colour == plots::palette::looks[2].colour);
}

TEST_CASE("the key calls unlisted series smaller only if the plot chose its own colours") {
  plots::Names names = numbered("a", 9);
  std::vector<plots::Plot> plots{make_chart("one", names), make_chart("other", {names.rbegin(), names.rend()})};
  plots::set_common_looks(plots);
  const auto last_of_key = [](const plots::Plot& plot) {
    return plots::series_looks(std::get<plots::Chart>(plot.content)).key.back().text;
  };
  CHECK(last_of_key(plots[0]) == "1 more, with smaller values (see table.csv)");
  CHECK(last_of_key(plots[1]) == "1 more (see table.csv)");
  CHECK(look_in(plots[1], "a8").colour == plots::palette::background.colour);
}

TEST_CASE("plots with looks from two calls get common looks from a third call for all") {
  std::vector<plots::Plot> first{make_chart("one", {"octree", "exact"}), make_chart("two", {"exact", "run"})};
  std::vector<plots::Plot> second{make_chart("three", {"run", "octree"}), make_chart("four", {"exact"})};
  plots::set_common_looks(first);
  plots::set_common_looks(second);
  first.insert(first.end(), second.begin(), second.end());
  plots::set_common_looks(first);
  for (const char* const name : {"exact", "octree", "run"}) {
    std::set<std::string_view> colours;
    std::set<plots::palette::Mark> marks;
    for (const plots::Plot& plot : first) {
      const auto& series = std::get<plots::Chart>(plot.content).series;
      if (std::ranges::find(series, name, &plots::Series::name) == series.end()) continue;
      colours.insert(look_in(plot, name).colour);
      marks.insert(look_in(plot, name).mark);
    }
    CHECK(colours.size() == 1);
    CHECK(marks.size() == 1);
  }
}

TEST_CASE("common_looks() omits names once all looks are taken") {
  const std::array<plots::Names, 1> plots{plots::Names{"a", "b", "c"}};
  CHECK(plots::common_looks(plots, 2, 2) == plots::Looks{{"a", 0}, {"b", 1}});
}