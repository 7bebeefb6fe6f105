#include "tests/support/properties.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "hw/base/hash.h"
#include "tests/support/usual_cases.h"

namespace csgsim::testing {

namespace {

std::string case_name;
std::uint32_t checked = 0;  ///< number of properties checked in this test case

void add_parameter(std::string_view word) {
  if (word.empty() || !parameter(word.substr(0, word.find('='))).empty()) return;
  const char* const before = std::getenv("RC_PARAMS");
  const bool is_empty = before == nullptr || *before == '\0';
  ::setenv("RC_PARAMS", (is_empty ? std::string(word) : fmt::format("{} {}", before, word)).c_str(), 1);
}

}  // namespace

void add_parameters(std::string_view parameters) {
  add_parameter(fmt::format("seed={}", fixed_seed));
  while (!parameters.empty()) {
    const std::size_t end = std::min(parameters.find(' '), parameters.size());
    add_parameter(parameters.substr(0, end));
    parameters.remove_prefix(std::min(end + 1, parameters.size()));
  }
}

void begin_case(std::string_view name) {
  case_name = name;
  checked = 0;
}

void begin_program(int count, const char* const* words) {
  std::string all;
  for (int i = 1; i < count; ++i) all += fmt::format("{} ", words[i]);
  begin_case(all);
}

std::uint64_t next_seed(std::uint64_t seed, std::string_view description) {
  Hash hash;
  hash.add(fmt::format("{} {} {} {}", seed, checked++, description, case_name));
  return hash.value();
}

}  // namespace csgsim::testing
