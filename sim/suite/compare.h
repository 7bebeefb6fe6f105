// Compares results of the benchmark suite with the expected ones.
// Used by sim/app.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "sim/suite/results.h"

namespace csgsim::suite {

/// A value that differs from the expected one.
struct Difference {
  std::string name;  ///< of the case
  std::string machine;
  std::string column;
  std::string expected;
  std::string found;

  bool operator==(const Difference&) const = default;
};

struct Comparison {
  std::size_t values = 0;  ///< number of compared values
  std::vector<Difference> differences;
};

/// Compares each cell that both rows fill. For a machine without expected values, a row of the case with an equal hash
/// in `program` gives the expected picture and counts of the Program; without such a row only pictures are compared.
Comparison compare(std::span<const Row> expected, const Row& found);

}  // namespace csgsim::suite
