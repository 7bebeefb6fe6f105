#pragma once

#include <cstdlib>
#include <string_view>

namespace csgsim::testing {

/// What RC_PARAMS sets a parameter of rapidcheck's to, as in `seed=1 max_success=8`; empty if it does not.
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

/// The seed of all properties unless RC_PARAMS names another.
inline constexpr std::string_view fixed_seed = "1";

/// Whether properties draw their default number of cases; sanitized runs set max_success to fewer.
inline bool draws_usual_number() { return parameter("max_success").empty(); }

inline bool draws_from_fixed_seed() {
  const std::string_view seed = parameter("seed");
  return seed.empty() || seed == fixed_seed;
}

/// Whether properties draw the cases of the suite, the same each time. Counts of what they have shown hold only then.
inline bool draws_usual_cases() { return draws_usual_number() && draws_from_fixed_seed(); }

/// How many cases a test tries that counts them itself: `few` where properties draw fewer.
template <class Number = int>
Number cases(Number usual, Number few) {
  return draws_usual_number() ? usual : few;
}

}  // namespace csgsim::testing
