#include "sim/plots/number_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace csgsim::plots {

namespace {

std::string superscript_text(int number) {
  constexpr std::array<std::string_view, 10> digits{"\u2070", "\u00b9", "\u00b2", "\u00b3", "\u2074",
                                                    "\u2075", "\u2076", "\u2077", "\u2078", "\u2079"};
  std::string text;
  for (const char digit : std::to_string(number))
    text += digit == '-' ? "\u207b" : digits[static_cast<std::size_t>(digit - '0')];
  return text;
}

/// Exponent of the power of 1,000 that serves as unit for a number of this size; 0 for no unit.
int unit_of(double largest) {
  if (largest == 0 || (largest >= 1e-3 && largest < 1e6)) return 0;
  return 3 * static_cast<int>(std::floor(std::log10(largest) / 3));
}

std::string unit_text(int unit) {
  switch (unit) {
    case 0: return "";
    case 6: return " M";
    case 9: return " G";
    case 12: return " T";
    default: return "\u00b710" + superscript_text(unit);
  }
}

/// Inserts a comma every three digits before the decimal point.
std::string grouped(std::string digits) {
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::size_t first = digits.front() == '-' ? 1 : 0;
  for (std::size_t at = point; at > first + 3;) digits.insert(at -= 3, ",");
  return digits;
}

/// Divides when the power of ten is exact in a double, and multiplies otherwise.
double in_units(double value, int unit) { return unit >= 0 ? value / std::pow(10, unit) : value * std::pow(10, -unit); }

}  // namespace

std::vector<std::string> number_texts(std::span<const double> values, int exponent) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  const int unit = unit_of(largest);
  const int decimals = std::max(0, unit - exponent);
  std::vector<std::string> texts;
  texts.reserve(values.size());
  for (const double value : values)
    texts.push_back(value == 0 ? "0"
                               : grouped(fmt::format("{:.{}f}", in_units(value, unit), decimals)) + unit_text(unit));
  return texts;
}

std::string power_text(int factor, int exponent, bool is_power) {
  if (is_power)
    return (factor == 1 ? std::string() : fmt::format("{}\u00b7", factor)) + "10" + superscript_text(exponent);
  return grouped(fmt::format("{:.{}f}", factor * std::pow(10, exponent), std::max(0, -exponent)));
}

std::string number_text(double value) {
  constexpr double max_whole = 9007199254740992.0;  // doubles represent all whole numbers up to 2^53
  constexpr double min_grouped = 999.5;
  const double size = std::abs(value);
  const bool is_whole = size <= max_whole && (size >= min_grouped || size == std::floor(size));
  return is_whole ? grouped(fmt::format("{:.0f}", std::round(value) + 0.0)) : fmt::format("{:.4g}", value);
}

}  // namespace csgsim::plots
