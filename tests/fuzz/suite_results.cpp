// Tables of results of the benchmark suite.

#include <algorithm>
#include <span>
#include <vector>

#include "sim/suite/compare.h"
#include "sim/suite/results.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace suite = csgsim::suite;

namespace {

void check(std::span<const suite::Row> rows) {
  try {
    const std::vector<suite::Row> again = suite::read_results(suite::results_text(rows), "again.csv");
    fuzz::require(std::ranges::equal(again, rows), "a table is read as written");
  } catch (const csgsim::InputError& error) {
    fuzz::broken(error.what());
  }
  for (const suite::Row& row : rows)
    fuzz::require(suite::compare(rows, row).differences.empty(), "a row does not differ from itself");
}

}  // namespace

/// Any bytes give rows that are written and read back unchanged, or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    check(suite::read_results(fuzz::text_of(data, size), "fuzz.csv"));
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.csv");
  }
  return 0;
}
