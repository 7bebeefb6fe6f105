#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/trace/measure.h"

namespace csgsim::studies {

/// The directories, what a ray meets in the form of the thesis's table 5.2, and seconds on each processor by part.
void print_tracing(std::span<const TraceRow> rows, std::span<const software::Priced> processors);

/// As the thesis's figures: rays by the cells that they look into (5.7); seconds by size of buckets (5.8) and by number
/// of polygons (5.9), where there are several.
std::vector<plots::Plot> plots_of_tracing(std::span<const TraceRow> rows, std::span<const software::Priced> processors,
                                          const std::string& model);

}  // namespace csgsim::studies
