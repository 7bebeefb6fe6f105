#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/sweep/points.h"

namespace csgsim::studies {

/// Of the rows of one model: scan-conversions and clocks against what is varied (axis.h), clocks against the
/// memory bits that the classification uses, and what each memory bit holds. None where no row has been compiled.
std::vector<plots::Plot> plots_of_sweep(std::span<const SweepRow> rows, const std::string& model);

}  // namespace csgsim::studies
