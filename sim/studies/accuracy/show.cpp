#include "sim/studies/accuracy/show.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include "host/emit/curves.h"
#include "hw/base/text.h"
#include "sim/plots/common_looks.h"
#include "sim/session/options/numbers.h"
#include "sim/studies/design/front.h"

namespace csgsim::studies {

namespace {

bool is_faceted(const Measurement& row) {
  return row.knob == "fn" || row.knob == "tolerance" ||
         (row.knob == "curves" && row.value == emit::name_of(emit::Curves::facets));
}

void print_row(const Measurement& row) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13.2e}{:>10.2f}{:>11}{:>13.2e}{:>9.3f}\n", row.knob, row.value,
             grouped(row.clocks), grouped(row.halfspaces), row.used_bits, grouped(row.wrong), grouped(row.unexplained),
             row.depth_p999, row.depth_p999_steps, grouped(row.facet_wrong), row.facet_depth_p999,
             row.picture_difference);
}

void print_table(std::span<const Measurement> rows, unsigned views) {
  fmt::print("{:<14}{:>12}{:>12}{:>9}{:>8}{:>9}{:>9}{:>13}{:>10}{:>11}{:>13}{:>9}\n", "knob", "value", "clocks",
             "planes", "bits", "wrong", "unexpl.", "depth p99.9", "in steps", "vs. curved", "curved p99.9", "colour");
  for (const Measurement& row : rows) print_row(row);
  if (views > 1)
    fmt::print(
        "Clocks and pixels are summed over {} views, depth errors are of the worst view; p99.9: 99.9th percentile.\n",
        views);
}

void print_front(std::span<const Measurement> rows) {
  const std::vector<Measurement> front = pareto_front(rows_of_knob(rows, "together"));
  if (front.empty()) return;
  fmt::print("\nPareto front of z bits / fraction bits:\n");
  for (const Measurement& row : front)
    fmt::print("  {:>6}{:>12} clocks{:>10} wrong pixels\n", row.value, grouped(row.clocks), grouped(row.wrong));
  for (const Halving& step : halvings(front)) {
    fmt::print("From {} to {}: {} wrong pixels become {} for {:.1f} % more clocks\n", step.from.value, step.to.value,
               grouped(step.from.wrong), grouped(step.to.wrong), 100.0 * step.more_clocks);
  }
}

void print_equal(std::span<const Measurement> rows) {
  for (const EqualFacets& one : equally_accurate_facets(rows)) {
    fmt::print("\n{} curves: {} clocks, {} wrong against curved surfaces\n", one.curved.value,
               grouped(one.curved.clocks), session::count_text(one.curved.facet_wrong, "pixel"));
    fmt::print(
        "{}: {} {}, {} clocks (factor {:.3g}), {} wrong\n",
        one.is_as_accurate ? "Facets of equal accuracy" : "No measured facets are as accurate; closest",
        one.facets.knob, one.facets.value, grouped(one.facets.clocks),
        static_cast<double>(one.facets.clocks) / static_cast<double>(std::max<std::uint64_t>(one.curved.clocks, 1)),
        session::count_text(one.facets.facet_wrong, "pixel"));
  }
}

constexpr const char* accuracy_table = "accuracy.csv";

/// Axis of a knob's plot, and whether errors refer to the half-spaces or to the curved surfaces.
struct KnobPlot {
  const char* name;
  const char* axis;
  plots::Scale scale;
  bool is_of_facets = false;
  bool has_value_ticks = true;  ///< whether the ticks are the measured values, not round numbers
};

constexpr KnobPlot knob_plots[] = {
    {"z-bits", "depth bits", plots::Scale::linear},
    {"fraction-bits", "fraction bits of the coefficients", plots::Scale::linear},
    {"edge-on", "edge-on fraction, pixels", plots::Scale::logarithmic},
    {"size", "picture size, pixels", plots::Scale::logarithmic},
    {"fn", "fragments per circle, $fn", plots::Scale::logarithmic, true},
    {"tolerance", "faceting tolerance, model units", plots::Scale::logarithmic, true, false},
};

/// Parses a number at the start of the text and removes it from the text.
double leading_number(std::string_view& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc()) text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// X coordinate of a value: the number itself, the fraction of `1/N`, or the width of `WxH`.
double place_of(std::string_view value) {
  const double number = leading_number(value);
  if (!value.starts_with('/')) return number;
  value.remove_prefix(1);
  return number / leading_number(value);
}

/// Title of an axis whose values are summed over the views of a point.
std::string sum_title(const char* what, unsigned views) {
  return views == 1 ? what : fmt::format("{}, sum of {} views", what, views);
}

plots::Plot knob_plot(const KnobPlot& knob, std::span<const Measurement> rows, const MeasuredModel& model) {
  plots::Chart chart{model.model + ": " + knob.axis,
                     {knob.axis, knob.scale},
                     {{sum_title(knob.is_of_facets ? "wrong pixels (curved)" : "wrong pixels", model.views),
                       plots::Scale::by_range,
                       {},
                       false,
                       true},
                      {"depth error (p99.9), model units"},
                      {sum_title("clocks", model.views), plots::Scale::by_range, {}, false, true}},
                     {{"", 0}, {"", 1}, {"", 2}},
                     accuracy_table};
  for (const Measurement& row : rows_of_knob(rows, knob.name)) {
    const double x = place_of(row.value);
    if (knob.has_value_ticks) chart.x.ticks.push_back({x, row.value});
    chart.series[0].points.push_back({x, static_cast<double>(knob.is_of_facets ? row.facet_wrong : row.wrong)});
    chart.series[1].points.push_back({x, knob.is_of_facets ? row.facet_depth_p999 : row.depth_p999});
    chart.series[2].points.push_back({x, static_cast<double>(row.clocks)});
  }
  for (plots::Series& series : chart.series) std::ranges::sort(series.points, {}, &plots::Point::x);
  return {knob.name, std::move(chart)};
}

plots::Point front_point(const Measurement& row, std::string label) {
  return {static_cast<double>(row.clocks), static_cast<double>(row.wrong), std::move(label)};
}

plots::Plot front_plot(std::span<const Measurement> together, const MeasuredModel& model) {
  plots::Chart chart{model.model + ": cost of accuracy",
                     {sum_title("clocks", model.views), plots::Scale::by_range, {}, false, true},
                     {{sum_title("wrong pixels", model.views), plots::Scale::logarithmic, {}, false, true}},
                     {{"z bits / fraction bits", 0, plots::Trace::marks, {}, true}, {"Pareto front"}},
                     accuracy_table};
  for (const Measurement& row : together) chart.series[0].points.push_back(front_point(row, ""));
  for (const Measurement& row : pareto_front(together)) chart.series[1].points.push_back(front_point(row, row.value));
  return {"pareto", std::move(chart)};
}

/// Facets of every number and curved surfaces: clocks against wrong pixels, both relative to the curved surfaces.
plots::Plot curves_plot(std::span<const Measurement> rows, const MeasuredModel& model) {
  plots::Chart chart{
      model.model + ": facets and curved surfaces",
      {sum_title("clocks", model.views), plots::Scale::logarithmic, {}, false, true},
      {{sum_title("wrong pixels against curved surfaces", model.views), plots::Scale::logarithmic, {}, false, true}},
      {{"facets, by tolerance"}, {"facets, by $fn"}, {"facets, as modelled", 0, plots::Trace::marks}},
      accuracy_table};
  for (const Measurement& row : rows) {
    const plots::Point at{static_cast<double>(row.clocks), static_cast<double>(row.facet_wrong), row.value};
    if (row.knob == "tolerance") chart.series[0].points.push_back(at);
    if (row.knob == "fn") chart.series[1].points.push_back(at);
    if (row.knob != "curves") continue;
    if (row.value == emit::name_of(emit::Curves::facets))
      chart.series[2].points.push_back({at.x, at.y});
    else
      chart.series.push_back({row.value + " curves", 0, plots::Trace::marks, {at}});
  }
  for (plots::Series& series : chart.series) std::ranges::sort(series.points, {}, &plots::Point::x);
  std::erase_if(chart.series, [](const plots::Series& series) { return series.points.empty(); });
  return {"curves", std::move(chart)};
}

}  // namespace

std::vector<Measurement> rows_of_knob(std::span<const Measurement> measurements, std::string_view knob) {
  std::vector<Measurement> rows;
  std::ranges::copy_if(measurements, std::back_inserter(rows),
                       [&](const Measurement& row) { return row.knob == knob; });
  return rows;
}

std::vector<Measurement> pareto_front(std::span<const Measurement> measurements) {
  return front_rows(measurements, [](const Measurement& row) {
    return Values{static_cast<double>(row.clocks), static_cast<double>(row.wrong)};
  });
}

std::vector<Halving> halvings(std::span<const Measurement> front) {
  std::vector<Halving> steps;
  for (std::size_t from = 0; from < front.size();) {
    std::size_t to = from + 1;
    while (to < front.size() && 2 * front[to].wrong > front[from].wrong) ++to;
    if (to == front.size()) break;
    const auto before = static_cast<double>(front[from].clocks);
    steps.push_back({front[from], front[to], (static_cast<double>(front[to].clocks) - before) / before});
    from = to;
  }
  return steps;
}

std::vector<EqualFacets> equally_accurate_facets(std::span<const Measurement> rows) {
  std::vector<EqualFacets> all;
  for (const Measurement& curved : rows) {
    if (curved.knob != "curves" || is_faceted(curved)) continue;
    const Measurement* best = nullptr;
    for (const Measurement& facets : rows) {
      if (!is_faceted(facets)) continue;
      // Facets that are at least as accurate as the curved surfaces rank equally in accuracy.
      const auto rank = [&](const Measurement& row) {
        return std::pair(std::max(row.facet_wrong, curved.facet_wrong), row.clocks);
      };
      if (best == nullptr || rank(facets) < rank(*best)) best = &facets;
    }
    if (best != nullptr) all.push_back({curved, *best, best->facet_wrong <= curved.facet_wrong});
  }
  return all;
}

void print_accuracy(std::span<const Measurement> rows, unsigned views) {
  print_table(rows, views);
  print_front(rows);
  print_equal(rows);
}

std::vector<plots::Plot> plots_of_accuracy(std::span<const Measurement> rows, const MeasuredModel& model) {
  std::vector<plots::Plot> all;
  for (const KnobPlot& knob : knob_plots) {
    if (std::ranges::find(rows, knob.name, &Measurement::knob) != rows.end())
      all.push_back(knob_plot(knob, rows, model));
  }
  if (std::ranges::find(rows, "curves", &Measurement::knob) != rows.end()) all.push_back(curves_plot(rows, model));
  if (const std::vector<Measurement> together = rows_of_knob(rows, "together"); !together.empty())
    all.push_back(front_plot(together, model));
  plots::set_common_looks(all);
  return all;
}

}  // namespace csgsim::studies
