#pragma once

#include <random>
#include <string>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::testing::plots_ {

/// Plots of all sorts: one point, equal points, hundreds, huge ranges, hostile names; named accordingly.
std::vector<plots::Plot> sample_plots();

/// A random chart: panels, series, values, labels and names.
plots::Chart random_chart(std::mt19937& random);

plots::Bars random_bars(std::mt19937& random);

}  // namespace csgsim::testing::plots_
