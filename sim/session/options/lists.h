// Parses comma-separated lists of option texts.
// Used by sim/session, sim/app and sim/studies.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::session {

/// Comma-separated numbers and ranges, as in `3..8`, `3,5,7` or `3..5,8`, in the given order without duplicates. Throws
/// InputError for any other text and for numbers below `min_number` or above `max_number`.
std::vector<unsigned> parse_numbers(std::string_view text, unsigned min_number, unsigned max_number);

/// The parts of a text between separators; parts may be empty.
std::vector<std::string_view> split(std::string_view text, std::string_view separator);

/// Comma-separated words, in the given order without duplicates. Throws InputError for an empty one.
std::vector<std::string> parse_words(std::string_view text);

/// Comma-separated words out of `known`. Throws InputError for an unknown word; the message calls it a `kind` and
/// suggests the nearest known word.
std::vector<std::string> parse_names(std::string_view text, std::string_view kind, std::span<const std::string> known);

}  // namespace csgsim::session
