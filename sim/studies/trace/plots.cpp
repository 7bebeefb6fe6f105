#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

#include "sim/studies/trace/show.h"

namespace csgsim::studies {

namespace {

using Rows = std::span<const TraceRow>;

void add(plots::Chart& chart, const std::string& name, std::size_t panel, const plots::Point& point) {
  auto series = std::ranges::find_if(chart.series,
                                     [&](const plots::Series& one) { return one.name == name && one.panel == panel; });
  if (series == chart.series.end()) series = chart.series.insert(series, {name, panel});
  series->points.push_back(point);
}

/// Rows without item buffer, with the first row's kind of rays, mailboxes and facet test.
std::vector<const TraceRow*> plain(Rows rows) {
  std::vector<const TraceRow*> found;
  for (const TraceRow& row : rows) {
    if (row.is_drawn() && row.point.item_buffer == "without" && row.point.cast == rows.front().point.cast &&
        row.point.mailboxes == rows.front().point.mailboxes && row.point.facet_test == rows.front().point.facet_test)
      found.push_back(&row);
  }
  return found;
}

template <class Value>
bool has_several(const std::vector<const TraceRow*>& rows, const Value& value) {
  std::set<double> values;
  for (const TraceRow* row : rows) values.insert(value(*row));
  return values.size() > 1;
}

constexpr std::size_t max_cells = 20;

/// Percentage of rays by number of visited cells; the last entry includes all higher numbers.
std::vector<double> shares_of(const TraceRow& row) {
  std::vector<double> shares;
  std::istringstream counts(row.rays_by_cells);
  for (std::uint64_t count = 0; counts >> count;) {
    const double share = 100.0 * static_cast<double>(count) / static_cast<double>(std::max<std::uint64_t>(1, row.rays));
    if (shares.size() <= max_cells) {
      shares.push_back(share);
    } else {
      shares.back() += share;
    }
  }
  return shares;
}

/// Uses the first bucket size and the first tolerance.
plots::Plot cells_plot(const std::vector<const TraceRow*>& rows, const std::string& model) {
  plots::Chart chart{model + ": cells visited per ray",
                     {fmt::format("cells ({0}: {0} or more)", max_cells), plots::Scale::linear, {}, false, true},
                     {{"rays, %", plots::Scale::linear}},
                     {},
                     "trace.csv"};
  for (const TraceRow* row : rows) {
    if (row->point.bucket_size != rows.front()->point.bucket_size ||
        row->point.tolerance != rows.front()->point.tolerance || row->point.directory == "none")
      continue;
    const std::vector<double> shares = shares_of(*row);
    for (std::size_t cells = 0; cells < shares.size(); ++cells)
      add(chart, row->point.directory, 0, {static_cast<double>(cells), shares[cells]});
  }
  return {"trace_cells", std::move(chart)};
}

void add_parts(plots::Chart& chart, const TraceRow& row, std::size_t panel, double x,
               const software::Priced& processor) {
  const TraceSeconds seconds = seconds_of(row, processor);
  if (!processor.processor) {
    add(chart, row.point.directory, panel, {x, seconds.all});
    return;
  }
  const std::string name = row.point.directory + ": ";
  add(chart, name + "traversal", panel, {x, seconds.traversal});
  add(chart, name + "intersection", panel, {x, seconds.intersection});
  add(chart, name + "classification and shading", panel, {x, seconds.classification + seconds.shading});
}

plots::Plot buckets_plot(const std::vector<const TraceRow*>& rows, std::span<const software::Priced> processors,
                         const std::string& model) {
  plots::Chart chart{model + ": time against bucket size",
                     {"facets per bucket", plots::Scale::linear, {}, false, true},
                     {},
                     {},
                     "trace.csv"};
  for (const software::Priced& processor : processors) {
    chart.panels.push_back({processor.name + ", s", plots::Scale::linear});
    for (const TraceRow* row : rows) {
      if (row->point.tolerance != rows.front()->point.tolerance) continue;
      add_parts(chart, *row, chart.panels.size() - 1, row->point.bucket_size, processor);
    }
  }
  return {"trace_buckets", std::move(chart)};
}

plots::Plot polygons_plot(const std::vector<const TraceRow*>& rows, std::span<const software::Priced> processors,
                          const std::string& model) {
  plots::Chart chart{
      model + ": time against polygons", {"polygons", plots::Scale::by_range, {}, false, true}, {}, {}, "trace.csv"};
  for (const software::Priced& processor : processors) {
    chart.panels.push_back({processor.name + ", s"});
    for (const TraceRow* row : rows) {
      if (row->point.bucket_size != rows.front()->point.bucket_size) continue;
      add(chart, row->point.directory, chart.panels.size() - 1,
          {static_cast<double>(row->polygons), seconds_of(*row, processor).all});
    }
  }
  for (plots::Series& series : chart.series) std::ranges::sort(series.points, {}, &plots::Point::x);
  return {"trace_polygons", std::move(chart)};
}

}  // namespace

std::vector<plots::Plot> plots_of_tracing(Rows rows, std::span<const software::Priced> processors,
                                          const std::string& model) {
  const std::vector<const TraceRow*> found = plain(rows);
  if (found.empty()) return {};
  std::vector<plots::Plot> plots{cells_plot(found, model)};
  if (has_several(found, [](const TraceRow& row) { return row.point.bucket_size; }))
    plots.push_back(buckets_plot(found, processors, model));
  if (has_several(found, [](const TraceRow& row) { return static_cast<double>(row.polygons); }))
    plots.push_back(polygons_plot(found, processors, model));
  return plots;
}

}  // namespace csgsim::studies
