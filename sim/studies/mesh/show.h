#pragma once

#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"
#include "sim/software/work.h"
#include "sim/studies/mesh/measure.h"

namespace csgsim::studies {

/// A column a tolerance, as in table 3.1 of the thesis: a table for each surface, way to test it and way to repair it.
void print_meshes(std::span<const MeshRow> rows, std::span<const software::Priced> processors);

/// Elements in all and at most held, against the tolerance.
std::vector<plots::Plot> plots_of_meshes(std::span<const MeshRow> rows, const std::string& model);

}  // namespace csgsim::studies
