#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <string>
#include <vector>

namespace csgsim::app {

/// `count` numbers of an option's text. Throws CLI::ValidationError, which shows the form that was expected.
template <typename Number>
std::vector<Number> numbers(const std::string& text, char separator, std::size_t count, const std::string& option,
                            const std::string& form) {
  std::vector<Number> values;
  const char* at = text.data();
  const char* const end = at + text.size();
  while (values.size() < count) {
    Number value{};
    const auto [next, error] = std::from_chars(at, end, value);
    const bool last = values.size() + 1 == count;
    if (error != std::errc{} || (last ? next != end : next == end || *next != separator)) {
      throw CLI::ValidationError(option, fmt::format("'{}' is not of the form {}", text, form));
    }
    values.push_back(value);
    at = last ? next : next + 1;
  }
  return values;
}

}  // namespace csgsim::app
