#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "sim/plots/plot.h"

namespace csgsim::plots {

using Names = std::vector<std::string>;

/// Places in a palette of so many looks, of names in several plots: a name has one look in all of them, and no two of
/// one plot share one. Names come first that come up first; as long as there are any, each gets one of the first
/// `apart` that no other has; then one that no other has in a plot with it. Names for which none is left have no place.
Looks common_looks(std::span<const Names> plots, std::size_t apart, std::size_t looks);

/// Has the series of all charts look alike where their names are the same.
void give_common_looks(std::vector<Plot>& plots);

}  // namespace csgsim::plots
