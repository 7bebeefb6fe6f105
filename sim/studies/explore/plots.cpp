#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "sim/plots/common_looks.h"
#include "sim/studies/explore/show.h"
#include "sim/studies/plot_names.h"

namespace csgsim::studies {

namespace {

/// Two of a group's axes, and what of its candidates stands there.
struct Panel {
  const ExploreGroup& group;
  std::size_t axis;  ///< against the first

  [[nodiscard]] plots::Point at(std::size_t candidate) const {
    return {group.values[candidate][0], group.values[candidate][axis]};
  }
};

/// The front of these two axes alone, from the least of the first on.
std::vector<plots::Point> pair_front(const Panel& panel) {
  std::vector<plots::Point> points;
  for (std::size_t i = 0; i < panel.group.values.size(); ++i) points.push_back(panel.at(i));
  std::ranges::sort(points, {}, [](const plots::Point& point) { return std::pair(point.x, point.y); });
  std::vector<plots::Point> front;
  for (const plots::Point& point : points) {
    if (front.empty() || point.y < front.back().y) front.push_back(point);
  }
  return front;
}

void add_panel(const Panel& panel, plots::Chart& chart) {
  const ExploreGroup& group = panel.group;
  const std::size_t number = chart.panels.size();
  const ExploreAxis& axis = group.axes[panel.axis];
  chart.panels.push_back({axis.title, plots::Scale::logarithmic});
  plots::Series beaten{number == 0 ? "another is better" : "", number, plots::Trace::marks, {}, true};
  plots::Series best{"Pareto front", number, plots::Trace::marks};
  for (std::size_t i = 0; i < group.values.size(); ++i) (group.front[i] ? best : beaten).points.push_back(panel.at(i));
  plots::Series of_two{"front of the two axes", number, plots::Trace::steps, pair_front(panel)};
  plots::Series knee{"knee", number, plots::Trace::marks, {panel.at(*group.knee)}};
  for (plots::Series* const series : {&beaten, &best, &of_two, &knee}) {
    if (!series->points.empty()) chart.series.push_back(std::move(*series));
  }
}

}  // namespace

std::vector<plots::Plot> plots_of_explore(std::span<const ShownGroup> groups) {
  std::vector<plots::Plot> all;
  std::map<std::string, unsigned> uses;
  for (const ShownGroup& shown : groups) {
    const ExploreGroup& group = shown.group;
    if (!group.knee || group.axes.size() < 2) continue;
    std::string name = group.model.empty() ? "all_models" : plot_stem(group.model);
    if (const unsigned use = ++uses[name]; use > 1) name += fmt::format("-{}", use);
    plots::Chart chart{fmt::format("{}: what {} buys", group.model.empty() ? "all models" : name, group.axes[0].name),
                       {group.axes[0].title, plots::Scale::logarithmic},
                       {},
                       {},
                       "explore.csv"};
    for (std::size_t axis = 1; axis < group.axes.size(); ++axis) add_panel({group, axis}, chart);
    all.push_back({name + "_front", std::move(chart)});
  }
  plots::give_common_looks(all);
  return all;
}

}  // namespace csgsim::studies
