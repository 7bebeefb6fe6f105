#pragma once

#include <string>
#include <vector>

#include "sim/plots/key.h"
#include "sim/plots/plot.h"

namespace csgsim::plots {

/// How each series of a chart is drawn, and the key that tells it.
struct SeriesLooks {
  std::vector<palette::Look> looks;  ///< of each series
  std::vector<KeyEntry> key;
};

/// Names of series, without those behind the others: first those that get colours where the chart stands alone, in its
/// order, then the others.
std::vector<std::string> names_by_choice(const Chart& chart);

SeriesLooks looks_of(const Chart& chart);

}  // namespace csgsim::plots
