// Five-number summary of a set of numbers.
// Used by csgsim corpus.
#pragma once

#include <vector>

namespace csgsim::studies {

/// Five-number summary and sum. Quartiles are interpolated linearly: quantile p is at position p * (count - 1) of the
/// sorted numbers, counted from 0.
struct Distribution {
  std::size_t count = 0;
  double total = 0;
  double minimum = 0;
  double first_quartile = 0;
  double median = 0;
  double third_quartile = 0;
  double maximum = 0;
};

/// All members are 0 for an empty list.
Distribution distribution_of(std::vector<double> numbers);

}  // namespace csgsim::studies
