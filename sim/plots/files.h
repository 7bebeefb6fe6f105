#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

/// Draws folder/NAME.svg and, by gnuplot, folder/NAME.png for each plot; returns the files. Throws InputError.
std::vector<std::filesystem::path> draw(std::span<const Plot> plots, const std::filesystem::path& folder);

}  // namespace csgsim::plots
