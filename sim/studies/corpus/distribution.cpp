#include "sim/studies/corpus/distribution.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace csgsim::studies {

namespace {

double quantile(const std::vector<double>& sorted, double part) {
  const double place = part * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

}  // namespace

Distribution distribution_of(std::vector<double> numbers) {
  if (numbers.empty()) return {};
  std::ranges::sort(numbers);
  return {numbers.size(),         std::accumulate(numbers.begin(), numbers.end(), 0.0),
          numbers.front(),        quantile(numbers, 0.25),
          quantile(numbers, 0.5), quantile(numbers, 0.75),
          numbers.back()};
}

}  // namespace csgsim::studies
