#include "sim/plots/chart_series.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "sim/plots/common_looks.h"

namespace csgsim::plots {

namespace {

/// Series with the same name.
struct Name {
  const Series* first;
  double largest;  ///< largest y value in the first panel that has the series
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

/// Moves the names with the largest values to the front if there are more names than colours.
void move_chosen_to_front(std::vector<Name>& names) {
  if (names.size() <= palette::max_series) return;
  std::vector<Name> sorted = names;
  std::ranges::stable_sort(sorted, std::ranges::greater(), &Name::largest);
  sorted.resize(palette::max_series);
  std::stable_partition(names.begin(), names.end(), [&](const Name& name) {
    return std::ranges::any_of(sorted, [&](const Name& one) { return one.first == name.first; });
  });
}

/// Maps each name to a look: the one shared by all charts of a study, or one chosen for this chart alone.
Looks places_of(const Chart& chart) {
  if (!chart.looks.empty()) return chart.looks;
  const std::array<Names, 1> alone{series_names_by_priority(chart)};
  return common_looks(alone, palette::max_series, palette::max_series);
}

/// Key entry for the uncoloured series. `smallest` is the smallest maximum among the coloured series.
std::string others_text(const std::vector<Name>& others, double smallest, const std::string& table) {
  const bool are_smaller = std::ranges::all_of(others, [&](const Name& one) { return one.largest <= smallest; });
  return fmt::format("{} more{} (see {})", others.size(), are_smaller ? ", with smaller values" : "", table);
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

std::vector<std::string> series_names_by_priority(const Chart& chart) {
  std::vector<Name> names = names_of(chart);
  move_chosen_to_front(names);
  std::vector<std::string> words;
  words.reserve(names.size());
  for (const Name& name : names) words.push_back(name.first->name);
  return words;
}

SeriesLooks series_looks(const Chart& chart) {
  const Looks places = places_of(chart);
  const auto look_of = [&](const std::string& name) {
    const auto place = places.find(name);
    return place == places.end() ? palette::background : palette::looks[place->second];
  };
  SeriesLooks result;
  for (const Series& series : chart.series)
    result.looks.push_back(series.is_background ? palette::background : look_of(series.name));
  std::vector<Name> others;
  double smallest = std::numeric_limits<double>::infinity();
  for (const Name& name : names_of(chart)) {
    const std::string& words = name.first->name;
    if (!places.contains(words)) {
      others.push_back(name);
      continue;
    }
    smallest = std::min(smallest, name.largest);
    if (!words.empty()) result.key.push_back({words, sample_of(name.first->trace), look_of(words)});
  }
  for (const Series& series : chart.series) {
    if (series.is_background && !series.name.empty())
      result.key.push_back({series.name, sample_of(series.trace), palette::background});
  }
  if (!others.empty())
    result.key.push_back(
        {others_text(others, smallest, chart.table), sample_of(others.front().first->trace), palette::background});
  return result;
}

}  // namespace csgsim::plots
