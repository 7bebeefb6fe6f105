#pragma once

#include <cstdlib>
#include <string_view>

namespace csgsim::testing {

/// Value of a rapidcheck parameter in RC_PARAMS, as in `seed=1 max_success=8`; empty if it is not set.
inline std::string_view parameter(std::string_view key) {
  const char* const all = std::getenv("RC_PARAMS");
  std::string_view rest = all == nullptr ? "" : all;
  while (!rest.empty()) {
    const std::string_view word = rest.substr(0, rest.find(' '));
    rest.remove_prefix(word.size() == rest.size() ? word.size() : word.size() + 1);
    if (word.starts_with(key) && word.substr(key.size()).starts_with('=')) return word.substr(key.size() + 1);
  }
  return {};
}

/// Seed of all properties unless RC_PARAMS sets another.
inline constexpr std::string_view fixed_seed = "1";

/// Whether properties draw their default number of cases; sanitized runs set max_success to a smaller number.
inline bool draws_usual_number() { return parameter("max_success").empty(); }

inline bool draws_from_fixed_seed() {
  const std::string_view seed = parameter("seed");
  return seed.empty() || seed == fixed_seed;
}

/// Whether properties draw the suite's fixed cases. Only then are counts of their results reproducible.
inline bool draws_usual_cases() { return draws_usual_number() && draws_from_fixed_seed(); }

/// Number of cases for a test with its own loop: `few` where properties draw a reduced number.
template <class Number = int>
Number cases(Number usual, Number few) {
  return draws_usual_number() ? usual : few;
}

}  // namespace csgsim::testing
