// Suggestions for misspelled words.
// Used wherever names, keys and options are looked up.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace csgsim {

/// Levenshtein distance: the number of insertions, deletions and replacements that turn one word into the other.
/// Ignores case.
std::size_t edit_distance(std::string_view from, std::string_view to);

/// The candidate with the smallest edit distance to the word; among equal ones, the first. Empty if there are no
/// candidates. Only the first 256 bytes of each word are compared.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// Like nearest(), but empty unless at least half of the word's characters (without leading dashes) remain unchanged.
std::string_view nearest_similar(std::string_view word, std::span<const std::string_view> candidates);

/// Error text for an unknown word, with a suggestion: `there is no strategy 'stak'; did you mean stack? The strategies
/// are stack, list`. `kind` is the singular noun for the known words.
std::string unknown_name_text(std::string_view kind, std::string_view word, std::span<const std::string_view> known);
std::string unknown_name_text(std::string_view kind, std::string_view word, std::span<const std::string> known);

}  // namespace csgsim
