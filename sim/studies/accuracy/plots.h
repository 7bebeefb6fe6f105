#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/accuracy/measure.h"

namespace csgsim::studies {

/// What was measured.
struct MeasuredModel {
  std::string model;
  unsigned views = 1;  ///< that each point was drawn in
};

/// Of each knob, what its values do to errors and clocks; and the Pareto front of z bits and fraction bits.
std::vector<plots::Plot> plots_of_accuracy(std::span<const Measurement> rows, const MeasuredModel& of);

}  // namespace csgsim::studies
