// Colours, dashes and marks of the series of a chart, and its key.
// Used by the layout of charts and by common_looks.cpp.
#pragma once

#include <string>
#include <vector>

#include "sim/plots/key.h"
#include "sim/plots/plot.h"

namespace csgsim::plots {

/// The look of each series of a chart, and the key.
struct SeriesLooks {
  std::vector<palette::Look> looks;  ///< one per series
  std::vector<KeyEntry> key;
};

/// Names of the foreground series: first those that get colours if the chart is drawn alone, in the chart's order, then
/// the others.
std::vector<std::string> series_names_by_priority(const Chart& chart);

/// Chooses the looks of all series of a chart and makes its key.
SeriesLooks series_looks(const Chart& chart);

}  // namespace csgsim::plots
