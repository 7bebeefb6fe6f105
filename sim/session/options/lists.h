#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::session {

/// Numbers as a list with commas of numbers and ranges: `3..8`, `3,5,7`, `3..5,8`; in that order, none twice. Throws
/// InputError for anything else, and for numbers below `least` or above `most`.
std::vector<unsigned> parse_numbers(std::string_view text, unsigned least, unsigned most);

/// The parts of a text between separators, any of which may be empty.
std::vector<std::string_view> split(std::string_view text, std::string_view separator);

/// Words with commas; in that order, none twice. Throws InputError for an empty one.
std::vector<std::string> parse_words(std::string_view text);

/// The same for words that have to be among the known ones, each of which is a `kind`; an unknown one is told with the
/// nearest known, if any is like it.
std::vector<std::string> parse_names(std::string_view text, std::string_view kind, std::span<const std::string> known);

}  // namespace csgsim::session
