// Lists of the cases of the benchmark suite.

#include <algorithm>
#include <cctype>

#include "sim/suite/suite.h"
#include "tests/fuzz/property.h"

namespace fuzz = csgsim::fuzz;
namespace suite = csgsim::suite;

/// Any bytes give a list whose cases have unique names and all settings, or one line of error.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  try {
    const suite::Suite list = suite::read_suite(fuzz::text_of(data, size), "fuzz.toml");
    for (const suite::Case& one : list.cases) {
      const auto is_harmless = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
      fuzz::require(!one.name.empty() && std::ranges::all_of(one.name, is_harmless), "a name is a plain file name");
      fuzz::require(&suite::case_named(list, one.name) == &one, "a case is found by its name");
      fuzz::require(one.settings.size() == list.cases.front().settings.size(), "every case has all settings");
      for (const auto& [key, value] : one.settings) fuzz::require(!value.empty(), "no setting is empty");
    }
  } catch (const csgsim::InputError& error) {
    fuzz::check_message(error, "fuzz.toml");
  }
  return 0;
}
