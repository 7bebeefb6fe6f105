#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "hw/base/markup.h"
#include "sim/plots/layout.h"
#include "sim/plots/svg.h"
#include "sim/report/parts_html.h"

namespace csgsim::report {

namespace {

Cell value_of(const plots::Axis& axis, double value) {
  if (!axis.is_names) return {value};
  const auto tick = std::ranges::find(axis.ticks, value, &plots::Tick::value);
  return tick == axis.ticks.end() ? Cell{} : Cell{tick->text};
}

bool has_labels(const plots::Series& series) {
  return std::ranges::any_of(series.points, [](const plots::Point& point) { return !point.label.empty(); });
}

/// The values of a panel; values that are not finite are not in the plot.
Table panel_table(const plots::Chart& chart, std::size_t panel) {
  const plots::Axis& y = chart.panels[panel];
  const bool is_labelled = std::ranges::any_of(chart.series, has_labels);
  Table table{chart.panels.size() > 1 ? y.title : "", {"", chart.x.title, y.title}, {}};
  if (is_labelled) table.columns.emplace_back("point");
  for (const plots::Series& series : chart.series) {
    if (series.panel != panel) continue;
    for (const plots::Point& point : series.points) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) continue;
      Row row{{series.name}, value_of(chart.x, point.x), value_of(y, point.y)};
      if (is_labelled) row.push_back({point.label});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

std::vector<Table> tables_of(const plots::Chart& chart) {
  std::vector<Table> tables;
  for (std::size_t panel = 0; panel < chart.panels.size(); ++panel) tables.push_back(panel_table(chart, panel));
  return tables;
}

std::vector<Table> tables_of(const plots::Bars& plot) {
  Table table{"", {"bar", "part", plot.x.title + ", from", "to"}, {}};
  for (const plots::Bar& bar : plot.bars) {
    for (const plots::Part& part : bar.parts) table.rows.push_back({{bar.name}, {part.name}, {part.begin}, {part.end}});
  }
  return {std::move(table)};
}

std::string what_is_shown(const plots::Chart& chart) {
  std::string upwards;
  for (const plots::Axis& panel : chart.panels) upwards += (upwards.empty() ? "" : ", ") + panel.title;
  return fmt::format("{}: {} against {}", chart.title, upwards, chart.x.title);
}

std::string what_is_shown(const plots::Bars& plot) { return fmt::format("{}: {}", plot.title, plot.x.title); }

}  // namespace

std::string plot_html(const plots::Plot& plot) {
  const auto said = std::visit([](const auto& content) { return markup_text(what_is_shown(content)); }, plot.content);
  const auto attributes =
      fmt::format("class=\"plot\" role=\"img\" aria-label=\"{}; the table below has its values\"", said);
  std::string html = fmt::format(
      "<figure class=plots>\n<div class=scroll tabindex=0 role=region aria-label=\"{}\">{}</div>\n"
      "<details><summary>Values of this plot</summary>\n",
      said, plots::svg_element(plots::lay_out(plot), attributes));
  for (const Table& table : std::visit([](const auto& content) { return tables_of(content); }, plot.content))
    html += table_html(table);
  return html + "</details>\n</figure>\n";
}

}  // namespace csgsim::report
