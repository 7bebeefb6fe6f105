#include "sim/plots/tips.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/plots/number_text.h"

namespace csgsim::plots {

namespace {

/// The value's text on the axis, or the number.
std::string value_text(const Axis& axis, double value) {
  const auto tick = std::ranges::find(axis.ticks, value, &Tick::value);
  return tick == axis.ticks.end() ? number_text(value) : tick->text;
}

}  // namespace

std::string tip_text(const Chart& chart, const Series& series, const Point& point) {
  std::string whose = series.name;
  if (!point.label.empty() && point.label != series.name) whose += (whose.empty() ? "" : ", ") + point.label;
  const Axis& y = chart.panels[series.panel];
  return fmt::format("{}{}{} {}, {} {}", whose, whose.empty() ? "" : ": ", chart.x.title, value_text(chart.x, point.x),
                     y.title, value_text(y, point.y));
}

std::string tip_text(const Bars& plot, const Bar& bar, const Part& part) {
  return fmt::format("{}: {}, {} {} to {}", bar.name, part.name, plot.x.title, value_text(plot.x, part.begin),
                     value_text(plot.x, part.end));
}

}  // namespace csgsim::plots
