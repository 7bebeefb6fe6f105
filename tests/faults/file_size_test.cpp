/// A limit on the size of files (ulimit -f) makes every longer write fail, whether by this program, by a library
/// through stdio, or by gnuplot.

#include <csignal>

#include "tests/faults/commands.h"
#include "tests/support/test.h"

namespace {

using namespace csgsim::testing::faults;

/// Limits of 0 and 1 bytes, half of the longest file, and each file's size minus one byte.
std::set<std::uint64_t> limits_of(const std::vector<std::uint64_t>& sizes) {
  std::set<std::uint64_t> limits{0, 1, std::ranges::max(sizes) / 2};
  for (const std::uint64_t size : sizes) limits.insert(size - 1);
  return limits;
}

void try_limits(const std::string& name) {
  CAPTURE(name);
  const Bench bench(command(name));
  const std::vector<std::uint64_t> sizes = bench.sizes();
  for (const std::uint64_t limit : limits_of(sizes)) {
    CAPTURE(limit);
    bench.reset();
    Conditions conditions;
    conditions.longest_file = limit;
    CHECK(bench.failure_mismatch(bench.run(conditions)) == "");
  }
  bench.reset();
  Conditions ample;
  ample.longest_file = 2 * std::ranges::max(sizes) + 100000;
  CHECK(bench.success_mismatch(bench.run(ample)) == "");
}

}  // namespace

TEST_CASE("pictures and stats that exceed the file size limit leave the old files") { try_limits("render"); }

TEST_CASE("a Program that exceeds the file size limit leaves the old file") { try_limits("compile"); }

TEST_CASE("a text that exceeds the file size limit leaves the old file") { try_limits("disasm"); }

TEST_CASE("a waveform that exceeds the file size limit leaves the old file") { try_limits("wave"); }

TEST_CASE("results of subdivide that exceed the file size limit leave the old files") { try_limits("subdivide"); }

TEST_CASE("a table that exceeds the file size limit keeps its complete lines") {
  try_limits("sweep");
  try_limits("accuracy going on");
}

TEST_CASE("a plot that exceeds the file size limit leaves the old file") { try_limits("compare with plots"); }

TEST_CASE("the file size signal ends csgsim but leaves old files and nothing else") {
  for (const char* const name : {"render", "wave", "sweep"}) {
    CAPTURE(name);
    const Bench bench(command(name));
    bench.reset();
    Conditions conditions;
    conditions.longest_file = 100;
    conditions.is_signalled = true;
    CHECK(bench.run(conditions).signal == SIGXFSZ);
    CHECK(bench.files_mismatch() == "");
  }
}
