#include <utility>

#include "sim/studies/classify/show.h"

namespace csgsim::studies {

namespace {

plots::Chart chart_of(const ClassifyGroup& group, std::span<const software::Priced> processors,
                      const std::string& model) {
  plots::Chart chart{model + ": classification time (tree " + group.shape + ", reduced: " + group.reduced + ")",
                     {"method", plots::Scale::linear, {}, true},
                     {},
                     {},
                     "classify.csv"};
  const std::vector<std::string> methods = methods_of(group.rows);
  for (std::size_t i = 0; i < methods.size(); ++i) chart.x.ticks.push_back({static_cast<double>(i), methods[i]});
  for (const software::Priced& processor : processors) {
    chart.panels.push_back({processor.name + ", s", plots::Scale::logarithmic});
    for (const std::string& coherence : coherences_of(group.rows)) {
      plots::Series series{coherence == "none" ? "whole rays" : coherence, chart.panels.size() - 1,
                           plots::Trace::marks};
      for (std::size_t i = 0; i < methods.size(); ++i) {
        const ClassifyRow* const row = find_row(group.rows, methods[i], coherence);
        if (row != nullptr && row->is_drawn())
          series.points.push_back({static_cast<double>(i), seconds_of(*row, processor).classification});
      }
      chart.series.push_back(std::move(series));
    }
  }
  return chart;
}

}  // namespace

std::vector<plots::Plot> plots_of_classification(std::span<const ClassifyRow> rows,
                                                 std::span<const software::Priced> processors,
                                                 const std::string& model) {
  std::vector<plots::Plot> plots;
  for (const ClassifyGroup& group : groups_of(rows))
    plots.push_back({"classify_" + group.shape + "_" + group.reduced, chart_of(group, processors, model)});
  return plots;
}

}  // namespace csgsim::studies
