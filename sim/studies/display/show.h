// Tables and plots of display methods.
// Used by csgsim display.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/display/measure.h"

namespace csgsim::studies {

/// The faceting of a point in words: a tolerance, a number of fragments, or the model's own.
std::string faceting_text(const DisplayPoint& point);

/// Prints a table per method in the form of the thesis's table 5.1, with a column per faceting, priced for each
/// processor; then wrong pixels and memory.
void print_display(std::span<const DisplayStudyRow> rows, std::span<const software::Priced> processors);

/// Time per picture against polygons of the model, with a panel per processor and a series per method.
std::vector<plots::Plot> plots_of_display(std::span<const DisplayStudyRow> rows,
                                          std::span<const software::Priced> processors, const std::string& model);

}  // namespace csgsim::studies
