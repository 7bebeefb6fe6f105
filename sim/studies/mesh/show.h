// Tables and plots of meshes.
// Used by csgsim mesh.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/software/work.h"
#include "sim/studies/mesh/measure.h"

namespace csgsim::studies {

/// Prints a table per surface, flatness test and repair, with a column per tolerance as in table 3.1 of the thesis.
void print_meshes(std::span<const MeshRow> rows, std::span<const software::Priced> processors);

/// Plots of the total number of elements and of the maximum held, against the tolerance.
std::vector<plots::Plot> plots_of_meshes(std::span<const MeshRow> rows, const std::string& model);

}  // namespace csgsim::studies
