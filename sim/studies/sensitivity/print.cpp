#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include "sim/session/options/numbers.h"
#include "sim/studies/design/value_text.h"
#include "sim/studies/sensitivity/show.h"

namespace csgsim::studies {

namespace {

using session::count_text;

/// Maximum number of printed rows of a table; the JSON file has all.
constexpr std::size_t max_printed = 12;

constexpr double least_whole = 9.95;  ///< changes from here on, in per cent, are printed without a fraction
constexpr double least_shown = 0.05;  ///< smaller changes, in per cent, are printed as 0

std::string group_name(const SensitivityGroup& group) { return group.model.empty() ? "All models" : group.model; }

std::string setting_text(const Variants& variants, const Setting& setting) { return variant_text(variants, {setting}); }

/// The values of figures that change a sign or a ranking.
std::string changes_text(const Variants& variants, const Changes& changes, std::string_view what) {
  std::string text = changes.figures.empty() ? fmt::format("no single figure changes the {}", what)
                                             : fmt::format("the {} changes with ", what);
  for (const Setting& setting : changes.figures)
    text += (&setting == &changes.figures.front() ? "" : ", ") + setting_text(variants, setting);
  if (changes.samples > 0)
    text += fmt::format("{}in {}", changes.figures.empty() ? ", but it changes " : " and ",
                        count_text(changes.samples, "sample"));
  return text;
}

/// `-37 to -10 %`, or one change if both texts are equal.
std::string range_text(double low, double high) {
  const std::string first = change_text(low);
  const std::string last = change_text(high);
  return first == last ? last : first.substr(0, first.find(' ')) + " to " + last;
}

std::vector<std::string> comparison_line(const Variants& variants, const ExploreAxis& axis,
                                         const Comparison& comparison) {
  const Span span = span_of(comparison.ratio);
  std::string samples;
  if (comparison.ratio.samples)
    samples = fmt::format("; {} in 90 % of {}", range_text(comparison.ratio.samples->p5, comparison.ratio.samples->p95),
                          count_text(comparison.ratio.samples->samples, "sample"));
  return {axis.name, change_text(comparison.ratio.base),
          fmt::format("({} over single figures{}); {}", range_text(span.low, span.high), samples,
                      changes_text(variants, comparison.sign, "sign"))};
}

void print_comparison(const SensitivityOutcome& outcome, const SensitivityGroup& group, std::size_t design,
                      const DesignLabels& designs) {
  std::vector<std::vector<std::string>> lines;
  for (const MetricOutcome& metric : group.metrics) {
    if (metric.comparisons[design])
      lines.push_back(comparison_line(outcome.variants, metric.axis, *metric.comparisons[design]));
  }
  if (lines.empty()) return;
  fmt::print("\n{}: {} against {}\n", group_name(group), designs.texts[group.designs[design]],
             designs.texts[group.designs.front()]);
  print_cells(lines, Align::left);
}

/// Prints the rankings of three or more designs; the ranking of two is the sign of their comparison.
void print_rankings(const SensitivityOutcome& outcome, const SensitivityGroup& group) {
  if (group.designs.size() < 3) return;
  fmt::print("\n{}: ranking of the {}\n", group_name(group), count_text(group.designs.size(), "design"));
  std::vector<std::vector<std::string>> lines;
  for (const MetricOutcome& metric : group.metrics)
    lines.push_back({metric.axis.name, changes_text(outcome.variants, metric.ranking, "ranking")});
  print_cells(lines, Align::left);
}

void print_refused(std::span<const ExploreRow> rows, const SensitivityOutcome& outcome, const SensitivityGroup& group,
                   const DesignLabels& designs) {
  for (const RefusedVariants& refused : group.refused) {
    const std::size_t row = refused.rows.front();
    const std::size_t design = row / outcome.order.variants % outcome.order.designs;
    fmt::print("  {} cannot be drawn, such as {} with {}: {}\n", count_text(refused.rows.size(), "variant"),
               designs.texts[design],
               variant_text(outcome.variants, outcome.variants.all[row % outcome.order.variants]), rows[row].reason);
  }
}

std::vector<std::string> effect_cells(const RangedFigure& figure, const FigureEffect& effect, double base) {
  std::vector<std::string> cells{figure.key, value_text(static_cast<double>(figure.value)), figure.unit};
  for (const auto& [limit, value] : {std::pair(figure.low, effect.low), std::pair(figure.high, effect.high)}) {
    cells.push_back(value_text(static_cast<double>(limit)));
    cells.push_back(value ? value_text(*value) : "none");
    cells.push_back(value && base != 0 ? change_text(*value / base) : "");
  }
  return cells;
}

void print_tornado(const Variants& variants, const ExploreAxis& axis, const Tornado& tornado, const std::string& of) {
  fmt::print("\n{}: {} {}", of, axis.title, value_text(tornado.base));
  if (tornado.samples)
    fmt::print("; 5, 50 and 95 % of {}: {}, {}, {}", count_text(tornado.samples->samples, "sample"),
               value_text(tornado.samples->p5), value_text(tornado.samples->p50), value_text(tornado.samples->p95));
  fmt::print("\n");
  std::vector<std::vector<std::string>> lines{{"figure", "stated", "", "low", "", "", "high", "", ""}};
  std::size_t effective = 0;
  for (const FigureEffect& effect : tornado.effects) {
    if (effect.swing == 0) continue;
    if (++effective <= max_printed)
      lines.push_back(effect_cells(variants.figures[effect.figure], effect, tornado.base));
  }
  if (effective > 0) print_cells(lines);
  if (effective > max_printed) fmt::print("  and {} more, in explore.json\n", effective - max_printed);
  const std::size_t idle = without_effect(tornado);
  if (idle > 0) fmt::print("  {} {}\n", count_text(idle, "figure"), idle == 1 ? "changes nothing" : "change nothing");
}

void print_tornados(const SensitivityOutcome& outcome, const SensitivityGroup& group, const DesignLabels& designs) {
  for (std::size_t i = 0; i < group.designs.size(); ++i) {
    for (const MetricOutcome& metric : group.metrics) {
      if (metric.tornados[i])
        print_tornado(outcome.variants, metric.axis, *metric.tornados[i], designs.texts[group.designs[i]]);
    }
  }
}

}  // namespace

std::string change_text(double ratio) {
  const double change = percent_change(ratio);
  if (std::abs(change) < least_shown) return "0 %";
  return std::abs(change) < least_whole ? fmt::format("{:+.1f} %", change) : fmt::format("{:+.0f} %", change);
}

void print_sensitivity(std::span<const ExploreRow> rows, const SensitivityOutcome& outcome,
                       const DesignLabels& designs) {
  fmt::print("\nSensitivity: {} over the ranges of {}, {} of each design\n",
             count_text(outcome.order.designs, "design"), count_text(outcome.variants.figures.size(), "assumed figure"),
             count_text(outcome.order.variants - 1, "variant"));
  for (const SensitivityGroup& group : outcome.groups) {
    if (!group.model.empty()) print_refused(rows, outcome, group, designs);
    for (std::size_t i = 1; i < group.designs.size(); ++i) print_comparison(outcome, group, i, designs);
    print_rankings(outcome, group);
  }
  print_tornados(outcome, outcome.groups.back(), designs);
}

}  // namespace csgsim::studies
