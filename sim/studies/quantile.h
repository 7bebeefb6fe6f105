// Quantiles of a set of numbers.
// Used by sim/studies/corpus and sim/studies/sensitivity.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace csgsim::studies {

/// The number at position part * (count - 1) of the sorted numbers, counted from 0 and interpolated linearly. `part`
/// from 0 to 1; there must be a number.
inline double quantile(std::span<const double> sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace csgsim::studies
