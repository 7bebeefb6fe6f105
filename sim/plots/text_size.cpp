#include "sim/plots/text_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

#include "hw/base/text.h"
#include "sim/plots/characters.h"

namespace csgsim::plots {

namespace {

constexpr std::string_view ellipsis = "\u2026";

/// Widths of U+0020 to U+007E in hundredths of the font size.
constexpr std::array<std::uint8_t, 95> ascii_widths{
    32, 41, 46, 84, 64, 96, 78, 28,  40,  40, 50, 84, 32, 38, 32, 46, 64, 64, 64, 64, 64, 64, 64, 64,
    64, 64, 34, 34, 84, 84, 84, 56,  102, 69, 69, 73, 78, 67, 62, 78, 77, 30, 50, 67, 56, 93, 77, 81,
    67, 81, 73, 67, 62, 74, 69, 104, 69,  67, 69, 40, 46, 40, 84, 56, 50, 62, 64, 55, 64, 62, 36, 64,
    64, 28, 28, 58, 28, 98, 64, 62,  64,  64, 42, 53, 40, 64, 60, 82, 60, 60, 53, 64, 34, 64, 84};

/// Characters up to `last`, and the width of the widest in units of the font size.
struct WidthRange {
  char32_t last;
  double width;
};

constexpr auto widths = std::to_array<WidthRange>({
    {0x00b6, 1.05},
    {0x00b7, 0.34},  // middle dot of powers of ten
    {0x01c3, 1.05},
    {0x0233, 1.45},  // digraphs
    {0x0370, 1.05},
    {0x0530, 1.35},  // Greek and Cyrillic
    {0x2025, 1.75},
    {0x2026, 1.05},  // ellipsis
    {0x206f, 1.75},
    {0x207e, 0.6},  // raised digits and signs
    {0x2fff, 1.75},
    {0x9fff, 1.1},
    {0xabff, 1.75},
    {0xd7ff, 1.1},
    {0xfdef, 1.75},
    {0xfdff, 12},  // ligatures of whole phrases
    {0xffff, 1.75},
    {0x10ffff, 2.2},
});

double width_of(char32_t character) {
  if (character >= 0x20 && character < 0x7f) return ascii_widths[character - 0x20] / 100.0;
  return std::ranges::find_if(widths, [&](const WidthRange& range) { return character <= range.last; })->width;
}

/// Replaces the middle by `between` and keeps the characters at both ends that fit.
std::string without_middle(std::string_view text, double width, std::string_view between) {
  const std::vector<std::string_view> characters = split_characters(text);
  std::string head;
  std::string tail;
  double left = width - text_width(between);
  for (std::size_t i = 0; i < characters.size(); ++i) {
    const std::size_t at = i / 2;
    const std::string_view next = i % 2 == 0 ? characters[at] : characters[characters.size() - 1 - at];
    left -= text_width(next);
    if (left < 0) break;
    i % 2 == 0 ? void(head += next) : void(tail.insert(0, next));
  }
  return head + std::string(between) + tail;
}

}  // namespace

double text_width(std::string_view text) {
  double width = 0;
  // Hinted fonts advance by whole pixels.
  for (const std::string_view character : split_characters(text))
    width += std::ceil(font_size * width_of(code_point(character)));
  return width;
}

std::string shorten(std::string_view text, double width) {
  std::string shown = printable(text);
  return text_width(shown) <= width ? shown : without_middle(shown, width, ellipsis);
}

std::vector<std::string> split_lines(std::string_view text, double width) {
  const std::string shown = printable(text);
  if (text_width(shown) <= width) return {shown};
  std::size_t cut = shown.rfind(' ');
  while (cut != std::string::npos && cut > 0 && text_width(std::string_view(shown).substr(0, cut)) > width)
    cut = shown.rfind(' ', cut - 1);
  if (cut == std::string::npos || cut == 0) return {shorten(shown, width)};
  return {shown.substr(0, cut), shorten(shown.substr(cut + 1), width)};
}

std::vector<std::string> shorten(const std::vector<std::string>& texts, double width) {
  std::map<std::string, std::set<std::string>> sources;
  std::vector<std::string> result;
  result.reserve(texts.size());
  for (const std::string& text : texts) {
    result.push_back(shorten(text, width));
    sources[result.back()].insert(text);
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    const std::set<std::string>& alike = sources.at(result[i]);
    if (alike.size() < 2) continue;
    const auto number = 1 + std::distance(alike.begin(), alike.find(texts[i]));
    result[i] = without_middle(printable(texts[i]), width, fmt::format("{}{}{}", ellipsis, number, ellipsis));
  }
  return result;
}

}  // namespace csgsim::plots
