// Tables and plots of ray tracing.
// Used by csgsim trace.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/trace/measure.h"

namespace csgsim::studies {

/// Prints the directories, what rays visit in the form of the thesis's table 5.2, and seconds by part on each
/// processor.
void print_tracing(std::span<const TraceRow> rows, std::span<const software::Priced> processors);

/// Plots as in the thesis: rays by number of visited cells (figure 5.7), and seconds by bucket size (5.8) and by number
/// of polygons (5.9) if there are several.
std::vector<plots::Plot> plots_of_tracing(std::span<const TraceRow> rows, std::span<const software::Priced> processors,
                                          const std::string& model);

}  // namespace csgsim::studies
