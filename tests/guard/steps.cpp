// csgsim_steps FILE: prints the number of steps of work for reading a model, a .csg or .jan file.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>

#include "host/commands/read.h"
#include "host/read/read.h"
#include "hw/base/work.h"

namespace {

std::uint64_t steps_to_read(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  csgsim::read::Options options;
  options.work = csgsim::Work(std::numeric_limits<std::uint64_t>::max());
  if (path.extension() == ".jan") {
    csgsim::commands::read_text(text, path.string(), options);
  } else {
    csgsim::read::read_csg_text(text, path.string(), options);
  }
  return options.work.done();
}

}  // namespace

int main(int count, char** words) {
  if (count != 2) return 2;
  try {
    std::printf("%llu\n", static_cast<unsigned long long>(steps_to_read(words[1])));
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "csgsim_steps: %s\n", error.what());
    return 1;
  }
}
