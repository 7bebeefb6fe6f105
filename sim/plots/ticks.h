// Positions and texts of ticks.
// Used by axes of charts and bars.
#pragma once

#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// About two to `max_count` multiples of 1, 2 or 5 times a power of ten in [low, high], low < high. No two texts are
/// equal. If `is_whole`, the step is at least 1.
std::vector<Tick> linear_ticks(double low, double high, unsigned max_count, bool is_whole = false);

/// Powers of ten in [low, high], 0 < low < high, with their multiples by 2 and 5 if there are few; linear ticks if
/// fewer than two are found. If `is_whole`, only whole numbers.
std::vector<Tick> logarithmic_ticks(double low, double high, unsigned max_count, bool is_whole = false);

}  // namespace csgsim::plots
