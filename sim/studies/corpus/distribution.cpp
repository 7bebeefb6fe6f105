#include "sim/studies/corpus/distribution.h"

#include <algorithm>
#include <numeric>

#include "sim/studies/quantile.h"

namespace csgsim::studies {

Distribution distribution_of(std::vector<double> numbers) {
  if (numbers.empty()) return {};
  std::ranges::sort(numbers);
  return {numbers.size(),         std::accumulate(numbers.begin(), numbers.end(), 0.0),
          numbers.front(),        quantile(numbers, 0.25),
          quantile(numbers, 0.5), quantile(numbers, 0.75),
          numbers.back()};
}

}  // namespace csgsim::studies
