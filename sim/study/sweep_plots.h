#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/study/sweep.h"

namespace csgsim::study {

/// Of the rows of one model: scan-conversions and clocks against what is varied (sweep_axis.h), clocks against the
/// memory bits that the classification uses, and what each memory bit holds. None where no row has been compiled.
std::vector<plots::Plot> plots_of_sweep(std::span<const SweepRow> rows, const std::string& model);

/// Draws them as PNG and SVG into a folder, by gnuplot. Returns the files. Throws InputError if gnuplot cannot be run.
std::vector<std::filesystem::path> draw_sweep(std::span<const SweepRow> rows, const std::string& model,
                                              const std::filesystem::path& folder);

}  // namespace csgsim::study
