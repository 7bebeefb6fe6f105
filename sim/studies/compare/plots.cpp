#include <algorithm>
#include <optional>
#include <utility>

#include "sim/plots/common_looks.h"
#include "sim/studies/compare/measure.h"
#include "sim/studies/groups.h"
#include "sim/studies/plot_names.h"

namespace csgsim::studies {

namespace {

constexpr const char* comparison_table = "compare.csv";
constexpr const char* interval_title = "time between frames, ms";
constexpr const char* drawing_title = "drawing time, ms";

/// A plot of the growth of times: the rows that it shows and the quantity on its x axis.
struct View {
  const char* name;
  const char* title;
  bool (*shows)(const ComparisonRow& row, const machines::Size& base);
  double (*against)(const ComparisonRow& row);
};

bool has_size(const ComparisonRow& row, const machines::Size& size) {
  return machines::Size{row.point.width, row.point.height} == size;
}

constexpr View views[] = {
    {"halfspaces", "half-spaces of the model", has_size,
     [](const ComparisonRow& row) { return static_cast<double>(row.halfspaces); }},
    {"pixels", "pixels of the picture",
     [](const ComparisonRow& row, const machines::Size& /*base*/) { return row.point.fragments == 0; },
     [](const ComparisonRow& row) { return static_cast<double>(row.point.width) * row.point.height; }},
};

double drawing_ms(const ComparisonRow& row) { return row.simulated_seconds * 1e3; }

/// Time for drawing, scan-out and everything else that the machine does before the next frame; infinite if unknown.
double interval_ms(const ComparisonRow& row) { return 1e3 / row.frames_per_second; }

plots::Chart growth_chart(std::span<const ComparisonRow> rows, const View& view, const machines::Size& base,
                          const std::string& model) {
  plots::Chart chart{model + ": time against " + view.title,
                     {view.title, plots::Scale::logarithmic},
                     {{interval_title, plots::Scale::logarithmic}, {drawing_title, plots::Scale::logarithmic}},
                     {},
                     comparison_table};
  for (const std::string& machine : machines_of(rows)) {
    plots::Series intervals{machine, 0};
    plots::Series drawings{machine, 1};
    for (const ComparisonRow& row : rows) {
      if (!row.is_drawn() || row.point.machine != machine || !view.shows(row, base)) continue;
      intervals.points.push_back({view.against(row), interval_ms(row)});
      drawings.points.push_back({view.against(row), drawing_ms(row)});
    }
    for (plots::Series* series : {&intervals, &drawings}) {
      std::ranges::stable_sort(series->points, {}, &plots::Point::x);
      if (!series->points.empty()) chart.series.push_back(std::move(*series));
    }
  }
  return chart;
}

bool varies(const plots::Chart& chart) {
  return std::ranges::any_of(
      chart.series, [](const plots::Series& series) { return series.points.front().x < series.points.back().x; });
}

/// A property shown for each machine, omitted if any machine lacks it.
struct Property {
  const char* title;
  std::optional<double> (*value)(const ComparisonRow& row);
};

constexpr Property properties[] = {
    {interval_title,
     [](const ComparisonRow& row) {
       return row.frames_per_second > 0 ? std::optional(interval_ms(row)) : std::nullopt;
     }},
    {drawing_title, [](const ComparisonRow& row) { return std::optional(drawing_ms(row)); }},
    {"memory bits in total",
     [](const ComparisonRow& row) { return std::optional(static_cast<double>(row.machine_memory_bits)); }},
    {"transistors in total", [](const ComparisonRow& row) {
       return row.machine_transistors ? std::optional(static_cast<double>(*row.machine_transistors)) : std::nullopt;
     }}};

void add_property(const Property& property, std::span<const ComparisonRow> own, plots::Chart& chart) {
  plots::Series series{"", chart.panels.size(), plots::Trace::marks};
  for (const ComparisonRow& row : own) {
    const std::optional<double> value = property.value(row);
    if (!value) return;
    series.points.push_back({static_cast<double>(series.points.size()), *value});
  }
  chart.panels.push_back({property.title});
  chart.series.push_back(std::move(series));
}

/// Chart of all machines: a picture of the first machine's size with the model's own facets.
plots::Chart machines_chart(std::span<const ComparisonRow> rows, const machines::Size& base, const std::string& model) {
  std::vector<ComparisonRow> own;
  std::vector<std::string> machines;
  for (const ComparisonRow& row : rows) {
    if (!row.is_drawn() || row.point.fragments != 0 || !row.point.ideal.empty() || !has_size(row, base)) continue;
    own.push_back(row);
    machines.push_back(row.point.machine);
  }
  plots::Chart chart{model + ": machines", {"machine", plots::Scale::linear, {}, true}, {}, {}, comparison_table};
  for (const std::string& name : machine_tick_labels(machines))
    chart.x.ticks.push_back({static_cast<double>(chart.x.ticks.size()), name});
  for (const Property& property : properties) add_property(property, own, chart);
  return chart;
}

}  // namespace

std::vector<plots::Plot> plots_of_comparison(std::span<const ComparisonRow> rows, const machines::Size& base,
                                             const std::string& model) {
  std::vector<plots::Plot> all;
  plots::Chart machines = machines_chart(rows, base, model);
  if (machines.x.ticks.size() > 1) all.push_back({"compare_machines", std::move(machines)});
  for (const View& view : views) {
    plots::Chart chart = growth_chart(rows, view, base, model);
    if (varies(chart)) all.push_back({std::string("compare_") + view.name, std::move(chart)});
  }
  plots::set_common_looks(all);
  return all;
}

}  // namespace csgsim::studies
