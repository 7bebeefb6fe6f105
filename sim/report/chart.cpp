#include "sim/report/chart.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <variant>

#include "sim/plots/extent.h"

namespace csgsim::report {

namespace {

Axis axis_of(const plots::Axis& axis, std::span<const double> values) {
  Axis shown{axis.title, plots::extent_of(values, axis.scale, plots::Begin::at_values).is_logarithmic};
  if (axis.is_names)
    for (const plots::Tick& tick : axis.ticks) shown.names.push_back(tick.text);
  return shown;
}

Series series_of(const plots::Series& series) {
  Series shown{series.name, {}, series.trace};
  for (const plots::Point& point : series.points) {
    if (std::isfinite(point.x) && std::isfinite(point.y)) shown.points.push_back({point.x, point.y, point.label});
  }
  return shown;
}

}  // namespace

std::vector<Plot> page_plots(const plots::Chart& chart) {
  std::vector<Plot> all;
  for (std::size_t panel = 0; panel < chart.panels.size(); ++panel) {
    Plot plot{chart.title, {}, {}, {}};
    std::vector<double> x;
    std::vector<double> y;
    for (const plots::Series& series : chart.series) {
      if (series.panel != panel) continue;
      Series shown = series_of(series);
      if (shown.points.empty()) continue;
      for (const Point& point : shown.points) {
        x.push_back(point.x);
        y.push_back(point.y);
      }
      plot.series.push_back(std::move(shown));
    }
    if (plot.series.empty()) continue;
    plot.x = axis_of(chart.x, x);
    plot.y = axis_of(chart.panels[panel], y);
    all.push_back(std::move(plot));
  }
  return all;
}

Section plots_section(std::span<const plots::Plot> plots) {
  Section section{"Plots", {}};
  for (const plots::Plot& plot : plots) {
    const auto* const chart = std::get_if<plots::Chart>(&plot.content);
    if (chart == nullptr) continue;
    for (Plot& shown : page_plots(*chart)) section.parts.emplace_back(std::move(shown));
  }
  return section;
}

}  // namespace csgsim::report
