#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>

#include "hw/base/text.h"
#include "sim/studies/sensitivity/show.h"

namespace csgsim::studies {

namespace {

constexpr std::size_t max_figures = 16;  ///< bars of a plot

/// A change in per cent, rounded for the text of a bar.
double change_of(double value, double base) { return std::round(10 * percent_change(value / base)) / 10; }

std::string whole_text(std::int64_t value) { return grouped(static_cast<std::uint64_t>(value)); }

plots::Part part_of(const char* name, double change) { return {name, std::min(change, 0.0), std::max(change, 0.0)}; }

double length(const plots::Part& part) { return part.end - part.begin; }

/// Lets the longer of two parts on one side of 0 begin where the shorter one ends.
void separate(std::vector<plots::Part>& parts) {
  if (parts.size() != 2) return;
  const auto [shorter, longer] =
      length(parts[0]) < length(parts[1]) ? std::tie(parts[0], parts[1]) : std::tie(parts[1], parts[0]);
  if (shorter.end > 0 && longer.end > 0) longer.begin = shorter.end;
  if (shorter.begin < 0 && longer.begin < 0) longer.end = shorter.begin;
}

plots::Bar bar_of(const RangedFigure& figure, const FigureEffect& effect, double base) {
  plots::Bar bar{fmt::format("{}: {} to {}", figure.key, whole_text(figure.low), whole_text(figure.high))};
  if (effect.low) bar.parts.push_back(part_of("at the low value", change_of(*effect.low, base)));
  if (effect.high) bar.parts.push_back(part_of("at the high value", change_of(*effect.high, base)));
  separate(bar.parts);
  std::erase_if(bar.parts, [](const plots::Part& part) { return length(part) == 0; });
  for (const plots::Part& part : bar.parts) bar.length = std::max(bar.length, part.end);
  return bar;
}

plots::Bars bars_of(const Variants& variants, const Tornado& tornado, std::string title, std::string axis) {
  plots::Bars bars{
      std::move(title), {std::move(axis)}, {}, {"at the low value", "at the high value"}, "explore.json", true};
  for (const FigureEffect& effect : tornado.effects) {
    plots::Bar bar = bar_of(variants.figures[effect.figure], effect, tornado.base);
    if (!bar.parts.empty() && bars.bars.size() < max_figures) bars.bars.push_back(std::move(bar));
  }
  return bars;
}

/// A plot unless no figure has an effect.
void add_plot(std::string name, plots::Bars bars, std::vector<plots::Plot>& all) {
  if (!bars.bars.empty() && all.size() < max_tornados) all.push_back({std::move(name), std::move(bars)});
}

}  // namespace

std::vector<plots::Plot> plots_of_sensitivity(const SensitivityOutcome& outcome, const DesignLabels& designs) {
  const SensitivityGroup& group = outcome.groups.back();
  std::vector<plots::Plot> all;
  for (std::size_t i = 0; i < group.designs.size(); ++i) {
    const std::size_t number = group.designs[i] + 1;
    const std::string& text = designs.texts[group.designs[i]];
    for (const MetricOutcome& metric : group.metrics) {
      if (const auto& tornado = metric.tornados[i]; tornado && tornado->base != 0)
        add_plot(fmt::format("tornado_{}_{}", metric.axis.name, number),
                 bars_of(outcome.variants, *tornado, text, fmt::format("change of {}, %", metric.axis.name)), all);
      if (const auto& comparison = metric.comparisons[i]; comparison && comparison->ratio.base != 0)
        add_plot(fmt::format("tornado_{}_{}_against_{}", metric.axis.name, number, group.designs.front() + 1),
                 bars_of(outcome.variants, comparison->ratio,
                         fmt::format("{} against {}", text, designs.texts[group.designs.front()]),
                         fmt::format("change of the ratio of {}, %", metric.axis.name)),
                 all);
    }
  }
  return all;
}

}  // namespace csgsim::studies
