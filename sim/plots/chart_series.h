#pragma once

#include <vector>

#include "sim/plots/key.h"
#include "sim/plots/plot.h"

namespace csgsim::plots {

/// How each series of a chart is drawn, and the key that tells it.
struct SeriesLooks {
  std::vector<palette::Look> looks;  ///< of each series
  std::vector<KeyEntry> key;
};

SeriesLooks looks_of(const Chart& chart);

}  // namespace csgsim::plots
