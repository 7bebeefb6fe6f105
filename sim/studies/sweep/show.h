#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/sweep/points.h"

/// What is shown of the rows of one model.
namespace csgsim::studies {

/// On standard output: every point, table 6.1 of the thesis, and what follows from them.
void print_sweep(std::span<const SweepRow> rows);

/// Scan-conversions and clocks against what is varied (axis.h), clocks against the memory bits that the classification
/// uses, and what each memory bit holds. None where no row has been compiled.
std::vector<plots::Plot> plots_of_sweep(std::span<const SweepRow> rows, const std::string& model);

/// Which bits of pixel memory hold what, a bar for each way in which the rows lay it out.
plots::Plot memory_plot(std::span<const SweepRow> rows, const std::string& model);

}  // namespace csgsim::studies
