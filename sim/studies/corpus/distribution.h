#pragma once

#include <vector>

namespace csgsim::studies {

/// Numbers in five and their sum. Quartiles between two numbers are interpolated: that of part p lies at place
/// p * (count - 1) of the sorted numbers, counted from 0.
struct Distribution {
  std::size_t count = 0;
  double total = 0;
  double minimum = 0;
  double first_quartile = 0;
  double median = 0;
  double third_quartile = 0;
  double maximum = 0;
};

/// Of no numbers all are 0.
Distribution distribution_of(std::vector<double> numbers);

}  // namespace csgsim::studies
