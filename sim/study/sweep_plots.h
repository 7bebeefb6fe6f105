#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/study/sweep.h"

namespace csgsim::study {

/// Draws, of the rows of one model, scan-conversions against the bits at hand, clocks against the bits used, and what
/// each memory bit holds, as PNG and SVG into a folder, by gnuplot. Returns the files. Throws InputError if gnuplot
/// cannot be run.
std::vector<std::filesystem::path> draw_sweep(std::span<const SweepRow> rows, const std::string& model,
                                              const std::filesystem::path& folder);

}  // namespace csgsim::study
