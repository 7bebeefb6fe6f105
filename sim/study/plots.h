#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/study/measure.h"

namespace csgsim::study {

/// What was measured.
struct MeasuredModel {
  std::string model;
  unsigned views = 1;  ///< that each point was drawn in
};

/// Of each knob, what its values do to errors and clocks; and the Pareto front of z bits and fraction bits.
std::vector<plots::Plot> plots_of_accuracy(std::span<const Measurement> rows, const MeasuredModel& of);

/// Draws them as PNG and SVG into a folder, by gnuplot. Returns the files. Throws InputError if gnuplot cannot be run.
std::vector<std::filesystem::path> draw_plots(std::span<const Measurement> rows, const MeasuredModel& of,
                                              const std::filesystem::path& folder);

}  // namespace csgsim::study
