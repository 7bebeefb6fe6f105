#include "sim/studies/accuracy/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <utility>

#include "host/emit/curves.h"
#include "sim/plots/common_looks.h"
#include "sim/studies/accuracy/pareto.h"

namespace csgsim::studies {

namespace {

constexpr const char* accuracy_table = "accuracy.csv";

/// What a knob is called, and which errors it makes.
struct KnobPlot {
  const char* name;
  const char* axis;
  const char* error;
  std::uint64_t Measurement::*wrong;  ///< pixels
  double Measurement::*depth;         ///< model units
  plots::Scale scale;
};

constexpr KnobPlot knob_plots[] = {
    {"z-bits", "bits of depth", "wrong pixels", &Measurement::wrong, &Measurement::depth_p999, plots::Scale::linear},
    {"fraction-bits", "fraction bits of the coefficients", "wrong pixels", &Measurement::wrong,
     &Measurement::depth_p999, plots::Scale::linear},
    {"edge-on", "edge-on fraction", "wrong pixels", &Measurement::wrong, &Measurement::depth_p999,
     plots::Scale::logarithmic},
    {"size", "picture size", "wrong pixels", &Measurement::wrong, &Measurement::depth_p999, plots::Scale::logarithmic},
    {"fn", "fragments of a circle, $fn", "pixels off curves", &Measurement::facet_wrong, &Measurement::facet_depth_p999,
     plots::Scale::logarithmic},
    {"tolerance", "faceting tolerance, model units", "pixels off curves", &Measurement::facet_wrong,
     &Measurement::facet_depth_p999, plots::Scale::logarithmic},
};

/// A number from a text's beginning; behind it stands the rest.
double leading_number(std::string_view& text) {
  double number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc()) text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return number;
}

/// Where a value stands: as a number, `1/N` as a fraction, `WxH` as the pixels of its width.
double place_of(std::string_view value) {
  const double number = leading_number(value);
  if (!value.starts_with('/')) return number;
  value.remove_prefix(1);
  return number / leading_number(value);
}

/// What is added up over the views of a point.
std::string sum_title(const char* what, unsigned views) {
  return views == 1 ? what : fmt::format("{}, sum of {} views", what, views);
}

plots::Plot knob_plot(const KnobPlot& knob, std::span<const Measurement> rows, const MeasuredModel& of) {
  plots::Chart chart{of.model + ": " + knob.axis,
                     {knob.axis, knob.scale},
                     {{sum_title(knob.error, of.views), plots::Scale::by_range, {}, false, true},
                      {"depth error, 99.9th percentile"},
                      {sum_title("clocks", of.views), plots::Scale::by_range, {}, false, true}},
                     {{"", 0}, {"", 1}, {"", 2}},
                     accuracy_table};
  for (const Measurement& row : of_knob(rows, knob.name)) {
    const double x = place_of(row.value);
    chart.x.ticks.push_back({x, row.value});
    chart.series[0].points.push_back({x, static_cast<double>(row.*knob.wrong)});
    chart.series[1].points.push_back({x, row.*knob.depth});
    chart.series[2].points.push_back({x, static_cast<double>(row.clocks)});
  }
  for (plots::Series& series : chart.series) std::ranges::sort(series.points, {}, &plots::Point::x);
  return {knob.name, std::move(chart)};
}

plots::Point front_point(const Measurement& row, std::string label) {
  return {static_cast<double>(row.clocks), static_cast<double>(row.wrong), std::move(label)};
}

plots::Plot front_plot(std::span<const Measurement> together, const MeasuredModel& of) {
  plots::Chart chart{of.model + ": what accuracy costs",
                     {sum_title("clocks", of.views), plots::Scale::by_range, {}, false, true},
                     {{sum_title("wrong pixels", of.views), plots::Scale::logarithmic, {}, false, true}},
                     {{"z bits / fraction bits", 0, plots::Trace::marks, {}, true}, {"Pareto front"}},
                     accuracy_table};
  for (const Measurement& row : together) chart.series[0].points.push_back(front_point(row, ""));
  for (const Measurement& row : pareto_front(together)) chart.series[1].points.push_back(front_point(row, row.value));
  return {"pareto", std::move(chart)};
}

/// Facets of every number, and curved surfaces without them: clocks against pixels off the true surfaces.
plots::Plot curves_plot(std::span<const Measurement> rows, const MeasuredModel& of) {
  plots::Chart chart{
      of.model + ": facets and curved surfaces",
      {sum_title("clocks", of.views), plots::Scale::logarithmic, {}, false, true},
      {{sum_title("pixels off the curved surfaces", of.views), plots::Scale::logarithmic, {}, false, true}},
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

std::vector<plots::Plot> plots_of_accuracy(std::span<const Measurement> rows, const MeasuredModel& of) {
  std::vector<plots::Plot> all;
  for (const KnobPlot& knob : knob_plots) {
    if (std::ranges::find(rows, knob.name, &Measurement::knob) != rows.end()) all.push_back(knob_plot(knob, rows, of));
  }
  if (std::ranges::find(rows, "curves", &Measurement::knob) != rows.end()) all.push_back(curves_plot(rows, of));
  if (const std::vector<Measurement> together = of_knob(rows, "together"); !together.empty())
    all.push_back(front_plot(together, of));
  plots::give_common_looks(all);
  return all;
}

}  // namespace csgsim::studies
