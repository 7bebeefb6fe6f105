#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// Lines `file: #include "..."` below a folder whose included path matches none of the allowed prefixes.
std::vector<std::string> strangers(const std::string& folder, const std::vector<std::string>& allowed) {
  static const std::regex include("^\\s*#\\s*include\\s*\"([^\"]+)\".*");
  std::vector<std::string> found;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(fs::path(CSGSIM_SOURCE_DIR) / folder)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream file(entry.path());
    for (std::string line; std::getline(file, line);) {
      std::smatch match;
      if (!std::regex_match(line, match, include)) continue;
      const std::string path = match[1];
      const bool fine = std::any_of(allowed.begin(), allowed.end(),
                                    [&](const std::string& prefix) { return path.starts_with(prefix); });
      if (!fine) found.push_back(entry.path().filename().string() + ": " + path);
    }
  }
  return found;
}

}  // namespace

TEST_CASE("the base room includes nothing of the others") { CHECK(strangers("hw/base", {"hw/base/"}).empty()); }

TEST_CASE("hw includes neither host nor sim") { CHECK(strangers("hw", {"hw/"}) == std::vector<std::string>{}); }

TEST_CASE("the array in plain C++ and the instruction set know nothing of SystemC's modules") {
  CHECK(strangers("hw/array", {"hw/array/", "hw/base/", "hw/isa/", "hw/machines/"}) == std::vector<std::string>{});
  CHECK(strangers("hw/isa", {"hw/base/", "hw/isa/"}) == std::vector<std::string>{});
  CHECK(strangers("hw/machines", {"hw/base/", "hw/isa/", "hw/machines/"}) == std::vector<std::string>{});
}

TEST_CASE("host includes nothing of hw but the base, the instruction set and the machine descriptions") {
  CHECK(strangers("host", {"host/", "hw/base/", "hw/isa/", "hw/machines/"}) == std::vector<std::string>{});
}

TEST_CASE("the engines share no code: each includes only itself, the engine interface and hw") {
  CHECK(strangers("sim/reference", {"sim/reference/", "sim/engine/", "hw/base/", "hw/isa/", "hw/machines/"}) ==
        std::vector<std::string>{});
  CHECK(strangers("sim/functional", {"sim/functional/", "sim/engine/", "hw/base/", "hw/isa/", "hw/machines/"}) ==
        std::vector<std::string>{});
  CHECK(strangers("sim/cycle", {"sim/cycle/", "sim/engine/", "hw/"}) == std::vector<std::string>{});
}
