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

/// Maps the series names of several plots to indices into a palette of `looks` looks. A name has the same look in all
/// plots, and no two names of one plot share a look. In order of first appearance, each name gets an unused look among
/// the first `apart` looks; once these are used up, a look that no name in the same plots has. Names for which no look
/// is left are not in the result.
Looks common_looks(std::span<const Names> plots, std::size_t apart, std::size_t looks);

/// Gives series with the same name the same look in all charts.
void give_common_looks(std::vector<Plot>& plots);

}  // namespace csgsim::plots
