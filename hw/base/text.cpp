#include "hw/base/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/locale/utf.hpp>
#include <cmath>
#include <iterator>

namespace csgsim {

namespace {

namespace utf = boost::locale::utf;

struct Range {
  utf::code_point first;
  utf::code_point last;
};

/// Control characters of ASCII and Latin-1, line and paragraph separators, and the marks, embeddings, overrides and
/// isolates that change the writing direction.
constexpr Range not_shown[] = {{0x00, 0x1f},     {0x7f, 0x9f},     {0x061c, 0x061c},
                               {0x200e, 0x200f}, {0x2028, 0x202e}, {0x2066, 0x2069}};

bool is_shown(utf::code_point point) {
  return std::none_of(std::begin(not_shown), std::end(not_shown),
                      [point](const Range& range) { return range.first <= point && point <= range.last; });
}

void append_escape(std::string& text, char byte) {
  switch (byte) {
    case '\n': text += "\\n"; return;
    case '\r': text += "\\r"; return;
    case '\t': text += "\\t"; return;
    default: text += fmt::format("\\x{:02x}", static_cast<unsigned char>(byte));
  }
}

/// The number with that many significant digits.
double to_digits(double value, int digits) {
  if (value == 0 || !std::isfinite(value)) return value;
  const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

}  // namespace

std::string printable(std::string_view bytes) {
  std::string text;
  text.reserve(bytes.size());
  for (auto at = bytes.begin(); at != bytes.end();) {
    auto next = at;
    const utf::code_point point = utf::utf_traits<char>::decode(next, bytes.end());
    if (utf::is_valid_codepoint(point) && is_shown(point)) {
      text.append(at, next);
      at = next;
    } else {
      append_escape(text, *at++);
    }
  }
  return text;
}

std::string escaped(std::string_view bytes) {
  std::string text;
  constexpr std::string_view formulas = "=+-@";
  if (!bytes.empty() && formulas.find(bytes.front()) != std::string_view::npos) {
    append_escape(text, bytes.front());
    bytes.remove_prefix(1);
  }
  while (!bytes.empty()) {
    const std::size_t plain = std::min(bytes.find('\\'), bytes.size());
    text += printable(bytes.substr(0, plain));
    if (plain < bytes.size()) text += "\\\\";
    bytes.remove_prefix(std::min(plain + 1, bytes.size()));
  }
  return text;
}

std::string shell_word(std::string_view bytes) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-+,:@%=";
  if (!bytes.empty() && bytes.find_first_not_of(plain) == std::string_view::npos) return std::string(bytes);
  if (printable(bytes) != bytes) {
    std::string word = "$'";
    for (const char byte : bytes) {
      if (plain.find(byte) != std::string_view::npos)
        word += byte;
      else
        word += fmt::format("\\{:03o}", static_cast<unsigned char>(byte));
    }
    return word + "'";
  }
  std::string word = "'";
  for (const char byte : bytes) word += byte == '\'' ? std::string("'\\''") : std::string(1, byte);
  return word + "'";
}

std::string grouped(std::uint64_t value) {
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
  return digits;
}

std::string rounded(double value, int digits) {
  constexpr double max_grouped = 1e18;  // larger numbers are written with an exponent
  const double shown = to_digits(value, digits);
  const double min_grouped = std::max(1000.0, std::pow(10.0, digits - 1));  // a whole number with that many digits
  const bool is_grouped = std::abs(shown) >= min_grouped && std::abs(shown) <= max_grouped;
  if (!is_grouped) return fmt::format("{:.{}g}", shown, digits);
  return (value < 0 ? "-" : "") + grouped(static_cast<std::uint64_t>(std::llround(std::abs(value))));
}

std::string quantity(double value, std::string_view unit) {
  constexpr std::array<std::string_view, 9> prefixes{"p", "n", "u", "m", "", "k", "M", "G", "T"};
  constexpr int no_prefix = 4;
  constexpr int digits = 3;
  const double shown = std::abs(to_digits(value, digits));
  int prefix = no_prefix;
  if (shown > 0 && std::isfinite(shown)) {
    const int last = unit == "s" ? no_prefix : static_cast<int>(prefixes.size()) - 1;
    prefix = std::clamp(no_prefix + static_cast<int>(std::floor(std::log10(shown) / 3.0)), 0, last);
  }
  const std::string suffix = fmt::format("{}{}", prefixes.at(static_cast<std::size_t>(prefix)), unit);
  return rounded(value / std::pow(1000.0, prefix - no_prefix), digits) + (suffix.empty() ? "" : " ") + suffix;
}

std::string binary_size(std::uint64_t bytes) {
  const std::uint64_t kib = bytes >> 10U;
  const std::uint64_t mib = kib >> 10U;
  if (mib == 0) return fmt::format("{} KiB", kib);
  return mib % 1024 == 0 ? fmt::format("{} GiB", mib / 1024) : fmt::format("{} MiB", mib);
}

}  // namespace csgsim
