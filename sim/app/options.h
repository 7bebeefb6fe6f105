#pragma once

#include <algorithm>
#include <string>

namespace csgsim::app {

/// For CLI11: what is wrong with a name of a file or folder, or nothing.
inline std::string not_empty(const std::string& name) { return name.empty() ? "the name is empty; name a file" : ""; }

/// For CLI11, which takes -1 for the greatest number of an unsigned option: what is wrong with a count, or nothing.
inline std::string whole_number(const std::string& text) {
  const bool is_digits =
      !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_digits ? "" : "'" + text + "' is not a whole number, 0 or more";
}

}  // namespace csgsim::app
