#include "sim/plots/glyphs.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <sstream>
#include <vector>

#include "hw/base/text.h"
#include "sim/plots/characters.h"
#include "sim/plots/program_limits.h"
#include "sim/system/child_process.h"
#include "sim/system/memory_file.h"

namespace csgsim::plots {

namespace {

/// An inclusive range of code points.
struct CharacterRange {
  char32_t first = 0;
  char32_t last = 0;
};

constexpr CharacterRange every_character{0, 0x10ffff};

/// Parses `20-7e` or `a9` (hexadecimal).
CharacterRange range_of(const std::string& words) {
  std::uint32_t first = 0;
  const char* const end = words.data() + words.size();
  const char* const behind = std::from_chars(words.data(), end, first, 16).ptr;
  std::uint32_t last = first;
  if (behind != end) std::from_chars(behind + 1, end, last, 16);
  return {first, last};
}

/// Ranges of all fonts. Each line holds a font's format and its ranges. Pango draws outlines from these two formats
/// only.
std::vector<CharacterRange> ranges_of(const std::string& listed) {
  std::vector<CharacterRange> ranges;
  std::istringstream lines(listed);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string word;
    if (!(words >> word) || (word != "TrueType" && word != "CFF")) continue;
    while (words >> word) ranges.push_back(range_of(word));
  }
  return ranges;
}

/// Sorts the ranges and merges those that overlap or touch.
std::vector<CharacterRange> joined(std::vector<CharacterRange> ranges) {
  std::ranges::sort(ranges, {}, &CharacterRange::first);
  std::vector<CharacterRange> all;
  for (const CharacterRange& range : ranges) {
    if (!all.empty() && range.first <= all.back().last + 1)
      all.back().last = std::max(all.back().last, range.last);
    else
      all.push_back(range);
  }
  return all;
}

/// The characters of all installed fonts.
std::vector<CharacterRange> installed() {
  const std::array<std::string, 3> words{"fc-list", "-f", "%{fontformat} %{charset}\\n"};
  const std::optional<system::ChildEnd> ended = system::run_child(words, system::MemoryFile("fc-list"), program_limits);
  if (!ended || !system::has_succeeded(*ended)) return {every_character};
  return joined(ranges_of(ended->output));
}

bool has_glyph(char32_t character) {
  static const std::vector<CharacterRange> known = installed();
  const auto range = std::ranges::lower_bound(known, character, {}, &CharacterRange::last);
  return range != known.end() && range->first <= character;
}

bool is_ascii(std::string_view character) { return character.size() == 1; }

}  // namespace

std::string replace_missing_glyphs(std::string_view text) {
  const std::string shown = printable(text);
  std::string result;
  for (const std::string_view character : split_characters(shown))
    result += is_ascii(character) || has_glyph(code_point(character)) ? character : "?";
  return result;
}

}  // namespace csgsim::plots
