// Five-number summary of a set of numbers.
// Used by csgsim corpus.
#pragma once

#include <vector>

namespace csgsim::studies {

/// Five-number summary and sum; quartiles by quantile().
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
