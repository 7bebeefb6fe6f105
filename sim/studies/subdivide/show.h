#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/studies/subdivide/measure.h"

namespace csgsim::studies {

/// A column a row, as in tables 7.2 and 7.3 of the thesis; of a machine that tells stages with the thesis's own.
void print_subdivision(std::span<const SubdivideRow> rows);

/// Half-spaces that are left in a square, and clocks of a frame, against the levels of subdivision, or, where these are
/// the same for all, against the half-spaces of the model. None of a single row.
std::vector<plots::Plot> plots_of_subdivision(std::span<const SubdivideRow> rows, const std::string& model);

}  // namespace csgsim::studies
