#pragma once

#include <span>
#include <string>

#include "sim/plots/plot.h"
#include "sim/studies/sweep/points.h"

namespace csgsim::studies {

/// Which bits of pixel memory hold what, a bar for each way in which the rows of one model lay it out.
plots::Plot memory_plot(std::span<const SweepRow> rows, const std::string& model);

}  // namespace csgsim::studies
