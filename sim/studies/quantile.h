// Quantiles of a set of numbers.
// Used by sim/studies/corpus and sim/studies/sensitivity.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace csgsim::studies {

/// Quantile of a non-empty set of numbers: the number at position fraction * (count - 1), from 0, of the sorted
/// numbers, interpolated linearly. `fraction` is from 0 to 1.
inline double quantile(std::span<const double> sorted_numbers, double fraction) {
  const double position = fraction * static_cast<double>(sorted_numbers.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(position));
  const std::size_t above = std::min(below + 1, sorted_numbers.size() - 1);
  return sorted_numbers[below] +
         (position - static_cast<double>(below)) * (sorted_numbers[above] - sorted_numbers[below]);
}

}  // namespace csgsim::studies
