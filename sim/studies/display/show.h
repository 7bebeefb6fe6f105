#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/display/measure.h"

namespace csgsim::studies {

/// The facets of a point, in words: a tolerance, a number of fragments, or the model's own.
std::string facets_text(const DisplayPoint& point);

/// Method by method, in the form of the thesis's table 5.1 with a column for each tolerance, priced for each processor;
/// then wrong pixels and memory.
void print_display(std::span<const DisplayStudyRow> rows, std::span<const software::Priced> processors);

/// Seconds by polygons of the model, a panel a processor and a line a method.
std::vector<plots::Plot> plots_of_display(std::span<const DisplayStudyRow> rows,
                                          std::span<const software::Priced> processors, const std::string& model);

}  // namespace csgsim::studies
