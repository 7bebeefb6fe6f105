#pragma once

#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// Some two to `most` multiples of 1, 2 or 5 times a power of ten from low to high, low < high, no two texts alike; of
/// 1 or more for values that are whole.
std::vector<Tick> linear_ticks(double low, double high, unsigned most, bool is_whole = false);

/// Powers of ten from low to high, 0 < low < high, and their 2- and 5-fold where there are few; where there are none of
/// these either, linear ticks. None between whole numbers for values that are whole.
std::vector<Tick> logarithmic_ticks(double low, double high, unsigned most, bool is_whole = false);

}  // namespace csgsim::plots
