/// A limit on the size of files (ulimit -f) makes every write past it fail, whoever writes: this program, a library
/// inside of stdio, or gnuplot.

#include <csignal>

#include "tests/faults/commands.h"
#include "tests/support/test.h"

namespace {

using namespace csgsim::testing::faults;

/// Nothing, one byte, half of the longest file, and all but a byte of each.
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
    CHECK(bench.wrong_in_failure(bench.run(conditions)) == "");
  }
  bench.reset();
  Conditions ample;
  ample.longest_file = 2 * std::ranges::max(sizes) + 100000;
  CHECK(bench.wrong_in_success(bench.run(ample)) == "");
}

}  // namespace

TEST_CASE("pictures and stats longer than files may be are told, and the old ones stay") { try_limits("render"); }

TEST_CASE("a Program longer than files may be is told, and the old one stays") { try_limits("compile"); }

TEST_CASE("a text longer than files may be is told, and the old one stays") { try_limits("disasm"); }

TEST_CASE("a waveform longer than files may be is told, and the old one stays") { try_limits("wave"); }

TEST_CASE("subdivide's figures longer than files may be are told, and the old ones stay") { try_limits("subdivide"); }

TEST_CASE("a study's table longer than files may be is told, and has whole lines") {
  try_limits("sweep");
  try_limits("accuracy going on");
}

TEST_CASE("a plot longer than files may be is told, and the old one stays") { try_limits("compare with plots"); }

TEST_CASE("the signal of a file that is too long ends csgsim, but leaves old files and nothing else") {
  for (const char* const name : {"render", "wave", "sweep"}) {
    CAPTURE(name);
    const Bench bench(command(name));
    bench.reset();
    Conditions conditions;
    conditions.longest_file = 100;
    conditions.is_signalled = true;
    CHECK(bench.run(conditions).signal == SIGXFSZ);
    CHECK(bench.wrong_in_files() == "");
  }
}
