#include "hw/base/nearest.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cstddef>
#include <numeric>
#include <vector>

namespace csgsim {

namespace {

/// Length limit of compared words, because the time grows with the product of their lengths.
constexpr std::size_t compared_bytes = 256;

char lower(char letter) { return static_cast<char>(std::tolower(static_cast<unsigned char>(letter))); }

}  // namespace

std::size_t edit_distance(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (const char letter : from) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < to.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(letter) == lower(to[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates) {
  const auto found = std::ranges::min_element(candidates, {},
                                              [beginning = word.substr(0, compared_bytes)](std::string_view candidate) {
                                                return edit_distance(beginning, candidate.substr(0, compared_bytes));
                                              });
  return found == candidates.end() ? std::string_view{} : *found;
}

std::string_view nearest_similar(std::string_view word, std::span<const std::string_view> candidates) {
  const std::string_view one = nearest(word, candidates);
  const std::size_t characters = word.size() - std::min(word.find_first_not_of('-'), word.size());
  return !one.empty() && edit_distance(word, one) * 2 <= characters ? one : std::string_view{};
}

namespace {

std::string plural(std::string_view kind) {
  constexpr std::string_view vowels = "aeiou";
  const bool has_vowel = kind.size() > 1 && vowels.find(kind[kind.size() - 2]) != vowels.npos;
  if (kind.ends_with('y') && !has_vowel) return fmt::format("{}ies", kind.substr(0, kind.size() - 1));
  if (kind == "axis") return "axes";
  return fmt::format("{}{}", kind, kind.ends_with('s') || kind.ends_with('x') ? "es" : "s");
}

}  // namespace

std::string unknown_name_text(std::string_view kind, std::string_view word, std::span<const std::string_view> known) {
  const std::string_view near = nearest_similar(word, known);
  const std::string question = near.empty() ? " the" : fmt::format(" did you mean {}? The", near);
  return fmt::format("there is no {} '{}';{} {} are {}", kind, word, question, plural(kind), fmt::join(known, ", "));
}

std::string unknown_name_text(std::string_view kind, std::string_view word, std::span<const std::string> known) {
  return unknown_name_text(kind, word, std::vector<std::string_view>(known.begin(), known.end()));
}

}  // namespace csgsim
