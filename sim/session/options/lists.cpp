#include "sim/session/options/lists.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <system_error>

#include "hw/base/error.h"
#include "hw/base/nearest.h"

namespace csgsim::session {

namespace {

template <class Value>
void add_once(std::vector<Value>& values, Value value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(std::move(value));
}

/// Advice for a range with another sign between its numbers, as in `12-20`.
std::string as_range(std::string_view word) {
  constexpr std::string_view digits = "0123456789";
  const std::size_t end = std::min(word.find_first_not_of(digits), word.size());
  const std::size_t next = word.find_first_of(digits, end);
  const bool is_range = end > 0 && next != word.npos && word.find_first_not_of(digits, next) == word.npos;
  return is_range ? fmt::format("; write {}..{}", word.substr(0, end), word.substr(next)) : "";
}

unsigned parse_number(std::string_view text, std::string_view word) {
  unsigned number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || end != text.data() + text.size() || text.empty())
    throw InputError(fmt::format("'{}' is neither a number nor a range such as 3..8{}", word, as_range(word)));
  return number;
}

}  // namespace

std::vector<std::string_view> split(std::string_view text, std::string_view separator) {
  std::vector<std::string_view> parts;
  for (std::size_t end = text.find(separator); end != text.npos; end = text.find(separator)) {
    parts.push_back(text.substr(0, end));
    text.remove_prefix(end + separator.size());
  }
  parts.push_back(text);
  return parts;
}

std::vector<std::string> parse_words(std::string_view text) {
  std::vector<std::string> words;
  for (const std::string_view word : split(text, ",")) {
    if (text.empty()) throw InputError("empty element in list ''; write values separated by commas");
    if (word.empty()) throw InputError(fmt::format("empty element in list '{}'; remove a comma", text));
    add_once(words, std::string(word));
  }
  return words;
}

std::vector<unsigned> parse_numbers(std::string_view text, unsigned least, unsigned most) {
  std::vector<unsigned> numbers;
  for (const std::string& word : parse_words(text)) {
    const std::string_view view = word;
    const std::size_t dots = view.find("..");
    const unsigned first = parse_number(view.substr(0, dots), word);
    const unsigned last = dots == std::string_view::npos ? first : parse_number(view.substr(dots + 2), word);
    if (last < first) throw InputError(fmt::format("range '{}' is reversed; use {}..{}", word, last, first));
    if (first < least || last > most) throw InputError(fmt::format("'{}' is not within {} to {}", word, least, most));
    for (unsigned number = first; number <= last; ++number) add_once(numbers, number);
  }
  return numbers;
}

std::vector<std::string> parse_names(std::string_view text, std::string_view kind, std::span<const std::string> known) {
  std::vector<std::string> words = parse_words(text);
  for (const std::string& word : words)
    if (std::find(known.begin(), known.end(), word) == known.end())
      throw InputError(unknown_name_text(kind, word, known));
  return words;
}

}  // namespace csgsim::session
