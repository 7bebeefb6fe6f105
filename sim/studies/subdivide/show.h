// Tables and plots of subdivided pictures.
// Used by csgsim subdivide.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/subdivide/measure.h"

namespace csgsim::studies {

/// Prints a column per row, as in tables 7.2 and 7.3 of the thesis; next to the thesis's values if the machine reports
/// stages.
void print_subdivision(std::span<const SubdivideRow> rows);

/// Plots of the remaining half-spaces per square and of the clocks per frame against the levels of subdivision or, if
/// these are constant, against the half-spaces of the model. Empty for a single row.
std::vector<plots::Plot> plots_of_subdivision(std::span<const SubdivideRow> rows, const std::string& model);

}  // namespace csgsim::studies
