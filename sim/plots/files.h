// Draws plots into SVG and PNG files.
// Used by sim/studies.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// Writes folder/NAME.svg and folder/NAME.png (by gnuplot) for each plot and returns the files. Throws InputError.
std::vector<std::filesystem::path> write_plots(std::span<const Plot> plots, const std::filesystem::path& folder);

}  // namespace csgsim::plots
