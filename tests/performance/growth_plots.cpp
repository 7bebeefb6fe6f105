#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/plots/files.h"
#include "tests/performance/report.h"

namespace csgsim::bench {

namespace {

/// A chart of all parts measured against the same size.
plots::Chart chart_of(const std::vector<Growth>& growths, const std::string& against) {
  plots::Chart chart{"csgsim against " + against,
                     {against, plots::Scale::logarithmic},
                     {{"ms", plots::Scale::logarithmic}},
                     {},
                     "bench.json"};
  for (const Growth& growth : growths) {
    if (growth.against != against) continue;
    const std::optional<double> power = growth.power();
    plots::Series series{power ? fmt::format("{}: exponent {:.2f}", growth.part, *power) : growth.part};
    for (const Point& point : growth.points) series.points.push_back({point.x, point.y * 1e3});
    chart.series.push_back(std::move(series));
    if (growth.others.empty()) continue;
    plots::Series& other = chart.series.emplace_back(plots::Series{growth.part + ", the other build"});
    for (const Point& point : growth.others) other.points.push_back({point.x, point.y * 1e3});
  }
  return chart;
}

}  // namespace

std::vector<plots::Plot> plots_of_growths(const std::vector<Growth>& growths) {
  std::vector<plots::Plot> all;
  for (const Growth& growth : growths) {
    const std::string name = "growth_" + growth.against;
    if (std::ranges::find(all, name, &plots::Plot::name) == all.end())
      all.push_back({name, chart_of(growths, growth.against)});
  }
  return all;
}

std::vector<std::filesystem::path> draw_growths(const Results& results) {
  return plots::write_plots(plots_of_growths(results.growths), results.settings.folder);
}

}  // namespace csgsim::bench
