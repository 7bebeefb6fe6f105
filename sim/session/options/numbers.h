// Parses numbers in option texts and formats counts.
// Used by sim/session, sim/app, sim/shell and sim/studies.
#pragma once

#include <fmt/format.h>

#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "hw/base/text.h"
#include "sim/session/options/usage.h"

namespace csgsim::session {

/// Reads exactly `count` numbers, with `separator` between them, from an option's text. Throws UsageError, which shows
/// `form`, the expected form.
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
      throw UsageError(option, fmt::format("'{}' is not of the form {}", text, form));
    }
    values.push_back(value);
    at = last ? next : next + 1;
  }
  return values;
}

/// The count and the noun, in the plural unless the count is 1: `1 bit`, `1,234 bits`.
inline std::string count_text(std::uint64_t count, std::string_view noun) {
  return fmt::format("{} {}{}", grouped(count), noun, count == 1 ? "" : "s");
}

/// Percentage of a whole; 0 if the whole is 0.
inline double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

}  // namespace csgsim::session
