// Assigns the same look to series with the same name in all plots of a study.
// Used by sim/studies.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

using Names = std::vector<std::string>;

/// Assigns to each series name of several plots the index of a look in a palette of `look_count` looks. A name has the
/// same look in all plots, and no two names of one plot share a look. In order of first appearance, names get different
/// looks until the first `distinct_looks` are used up; each further name gets a look that no other name of its plots
/// has. Names for which no look is left are not in the result.
Looks common_looks(std::span<const Names> names_by_plot, std::size_t distinct_looks, std::size_t look_count);

/// Gives series with the same name the same look in all charts.
void set_common_looks(std::vector<Plot>& plots);

}  // namespace csgsim::plots
