#include "tests/performance/build.h"

#include <fmt/format.h>
#include <hwy/highway.h>

#include <fstream>
#include <sstream>
#include <thread>

#include "hw/base/text.h"
#include "tests/performance/runs.h"

namespace csgsim::bench {

namespace {

std::string cpu_model() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

/// The best instruction set for which kernels are compiled and which the processor has: the lowest bit.
std::string best_vectors() {
  const auto both = hwy::SupportedTargets() & (HWY_TARGETS);
  return hwy::TargetName(both & -both);
}

}  // namespace

Build this_build() {
  return {CSGSIM_COMMIT, CSGSIM_COMPILER, CSGSIM_FLAGS, cpu_model(), std::thread::hardware_concurrency(),
          best_vectors()};
}

std::string name_of_build(const std::filesystem::path& csgsim_path) {
  std::istringstream lines(run_to_end({csgsim_path.native(), "--version"}).output);
  for (std::string word; lines >> word;) {
    if (word == "commit" && lines >> word) return "commit " + word.substr(0, word.find(','));
  }
  return fmt::format("`{}`", printable(csgsim_path.filename().native()));
}

}  // namespace csgsim::bench
