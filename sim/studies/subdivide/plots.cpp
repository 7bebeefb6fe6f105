#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "sim/studies/subdivide/show.h"

namespace csgsim::studies {

namespace {

constexpr std::pair<const char*, Squares SubdivideRow::*> parts[] = {{"segments", &SubdivideRow::segments},
                                                                     {"subsegments", &SubdivideRow::subsegments}};

void add(plots::Chart& chart, const std::string& name, std::size_t panel, const plots::Point& point) {
  auto series = std::ranges::find_if(chart.series,
                                     [&](const plots::Series& one) { return one.name == name && one.panel == panel; });
  if (series == chart.series.end()) series = chart.series.insert(series, {name, panel});
  series->points.push_back(point);
}

}  // namespace

std::vector<plots::Plot> plots_of_subdivision(std::span<const SubdivideRow> rows, const std::string& model) {
  if (rows.size() < 2) return {};
  const bool is_by_levels = rows.front().subdivisions != rows.back().subdivisions;
  plots::Chart chart{model + ": remaining work per square",
                     {is_by_levels ? "levels of binary subdivision" : "half-spaces of the model",
                      plots::Scale::linear,
                      {},
                      false,
                      true},
                     {{"mean half-spaces per square"}, {"clocks per frame", plots::Scale::by_range, {}, false, true}},
                     {},
                     "subdivide.csv"};
  for (const SubdivideRow& row : rows) {
    const double x = is_by_levels ? row.subdivisions : static_cast<double>(row.halfspaces);
    for (const auto& [part, squares] : parts) {
      const std::string name =
          is_by_levels && row.tolerance ? fmt::format("{}, tolerance {:g}", part, *row.tolerance) : part;
      add(chart, name, 0, {x, (row.*squares).kept_halfspaces});
      if (const std::optional<std::uint64_t> clocks = (row.*squares).clocks)
        add(chart, name, 1, {x, static_cast<double>(*clocks)});
    }
  }
  for (plots::Series& series : chart.series) std::ranges::sort(series.points, {}, &plots::Point::x);
  return {{"subdivide", std::move(chart)}};
}

}  // namespace csgsim::studies
