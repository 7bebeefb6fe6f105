#include "sim/plots/chart_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace csgsim::plots {

namespace {

/// Series of one name.
struct Name {
  const Series* first;
  double largest;  ///< in the first panel that they are in
};

std::vector<Name> names_of(const Chart& chart) {
  std::vector<Name> names;
  for (const Series& series : chart.series) {
    if (series.is_background) continue;
    auto known = std::ranges::find_if(names, [&](const Name& one) { return one.first->name == series.name; });
    if (known == names.end()) known = names.insert(names.end(), {&series, -std::numeric_limits<double>::infinity()});
    if (series.panel != known->first->panel) continue;
    for (const Point& point : series.points) {
      if (std::isfinite(point.y)) known->largest = std::max(known->largest, point.y);
    }
  }
  return names;
}

/// The names that get colours, in the order of the chart.
std::vector<const Series*> chosen(std::vector<Name> names) {
  if (names.size() > palette::most_series) {
    std::vector<Name> sorted = names;
    std::ranges::stable_sort(sorted, std::ranges::greater(), &Name::largest);
    sorted.resize(palette::most_series);
    std::erase_if(names, [&](const Name& name) {
      return std::ranges::none_of(sorted, [&](const Name& one) { return one.first == name.first; });
    });
  }
  std::vector<const Series*> series;
  series.reserve(names.size());
  for (const Name& name : names) series.push_back(name.first);
  return series;
}

Sample sample_of(Trace trace) {
  switch (trace) {
    case Trace::line:
    case Trace::steps: return Sample::line;
    case Trace::marks: return Sample::mark;
    case Trace::level:
    case Trace::upright: return Sample::level;
  }
  return Sample::none;
}

}  // namespace

SeriesLooks looks_of(const Chart& chart) {
  const std::vector<Name> names = names_of(chart);
  const std::vector<const Series*> coloured = chosen(names);
  SeriesLooks result;
  for (const Series& series : chart.series) {
    const auto found = std::ranges::find(coloured, series.name, [](const Series* one) { return one->name; });
    const bool is_coloured = !series.is_background && found != coloured.end();
    result.looks.push_back(is_coloured ? palette::looks[static_cast<std::size_t>(found - coloured.begin())]
                                       : palette::background);
  }
  for (std::size_t i = 0; i < coloured.size(); ++i) {
    if (!coloured[i]->name.empty())
      result.key.push_back({coloured[i]->name, sample_of(coloured[i]->trace), palette::looks[i]});
  }
  for (const Series& series : chart.series) {
    if (series.is_background && !series.name.empty())
      result.key.push_back({series.name, sample_of(series.trace), palette::background});
  }
  if (coloured.size() < names.size()) {
    result.key.push_back({fmt::format("{} more, with smaller values: {}", names.size() - coloured.size(), chart.table),
                          sample_of(coloured.front()->trace), palette::background});
  }
  return result;
}

}  // namespace csgsim::plots
