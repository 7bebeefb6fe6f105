#pragma once

#include <cstdlib>
#include <string_view>

namespace csgsim::testing {

/// Whether properties draw as many cases as they do by themselves: RC_PARAMS, by which sanitized runs draw fewer, does
/// not say how many. Counts of what the cases have shown hold only then.
inline bool draws_usual_cases() {
  const char* const parameters = std::getenv("RC_PARAMS");
  return parameters == nullptr || std::string_view(parameters).find("max_success") == std::string_view::npos;
}

/// How many cases a test tries that counts them itself: `few` where properties draw fewer.
template <class Number = int>
Number cases(Number usual, Number few) {
  return draws_usual_cases() ? usual : few;
}

}  // namespace csgsim::testing
