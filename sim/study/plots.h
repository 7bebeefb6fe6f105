#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/study/measure.h"

namespace csgsim::study {

/// Draws error against clocks, a plot a knob, and the Pareto front of z bits and fraction bits, as PNG and SVG into a
/// folder, by gnuplot. Returns the files. Throws InputError if gnuplot cannot be run.
std::vector<std::filesystem::path> draw_plots(std::span<const Measurement> rows, const std::string& model,
                                              const std::filesystem::path& folder);

}  // namespace csgsim::study
