#pragma once

#include <random>
#include <string>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::testing::plots_ {

/// Plots of one point, equal points, hundreds of points, huge ranges and hostile names; each is named after its
/// contents.
std::vector<plots::Plot> sample_plots();

/// A random chart: panels, series, values, labels and names.
plots::Chart random_chart(std::mt19937& random);

plots::Bars random_bars(std::mt19937& random);

}  // namespace csgsim::testing::plots_
