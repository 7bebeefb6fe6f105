#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>

#include "hw/machines/machine.h"

namespace csgsim::fuzz {

/// The text as a TOML string.
inline std::string toml_string(std::string_view text) {
  std::string out = "\"";
  for (const char letter : text) {
    const auto code = static_cast<unsigned char>(letter);
    const bool plain = code >= 0x20U && code != 0x7fU && letter != '"' && letter != '\\';
    out += plain ? std::string(1, letter) : fmt::format("\\u{:04x}", code);
  }
  return out + '"';
}

/// The lines of a parameter's range; empty if it has none.
inline std::string range_lines(const machines::Figure& figure) {
  if (!figure.range) return {};
  return fmt::format("low = {}\nhigh = {}\nrange = {}\n", figure.range->low, figure.range->high,
                     toml_string(figure.range->reason));
}

inline bool same_ranges(const machines::Figure& a, const machines::Figure& b) {
  if (!a.range || !b.range) return a.range.has_value() == b.range.has_value();
  return a.range->low == b.range->low && a.range->high == b.range->high && a.range->reason == b.range->reason;
}

inline bool same_figures(std::span<const machines::Figure> some, std::span<const machines::Figure> others) {
  return std::ranges::equal(some, others, [](const machines::Figure& a, const machines::Figure& b) {
    return a.key == b.key && a.value == b.value && a.unit == b.unit && a.provenance == b.provenance &&
           a.source == b.source && same_ranges(a, b);
  });
}

}  // namespace csgsim::fuzz
