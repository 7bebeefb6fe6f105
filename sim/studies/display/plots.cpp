#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "sim/studies/display/show.h"

namespace csgsim::studies {

std::vector<plots::Plot> plots_of_display(std::span<const DisplayStudyRow> rows,
                                          std::span<const software::Priced> processors, const std::string& model) {
  plots::Chart chart{model + ": time per picture, without preprocessing",
                     {"polygons of the model", plots::Scale::by_range},
                     {},
                     {},
                     "display.csv"};
  for (const software::Priced& processor : processors) {
    chart.panels.push_back({processor.name + ", s", plots::Scale::logarithmic});
    const std::size_t panel = chart.panels.size() - 1;
    for (const DisplayStudyRow& row : rows) {
      if (!row.is_drawn()) continue;
      const std::string name = row.point.bucket_size == 0 ? row.point.method
                                                          : fmt::format("{} {} {}", row.point.method,
                                                                        row.point.directory, row.point.bucket_size);
      auto series = std::ranges::find_if(
          chart.series, [&](const plots::Series& one) { return one.name == name && one.panel == panel; });
      if (series == chart.series.end()) series = chart.series.insert(series, {name, panel});
      series->points.push_back({static_cast<double>(row.polygons), display_seconds(row, processor).total});
    }
  }
  for (plots::Series& series : chart.series) std::ranges::sort(series.points, {}, &plots::Point::x);
  return {{"display", std::move(chart)}};
}

}  // namespace csgsim::studies
