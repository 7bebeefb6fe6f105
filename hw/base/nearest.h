#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace csgsim {

/// Insertions, deletions and replacements of characters that turn one word into the other (Levenshtein's distance);
/// upper and lower case are the same.
std::size_t edit_distance(std::string_view from, std::string_view to);

/// The candidate that the fewest insertions, deletions and replacements of characters turn into the word; the first of
/// those equally near, empty if there are no candidates. Of words longer than 256 bytes only the beginnings count.
std::string_view nearest(std::string_view word, std::span<const std::string_view> candidates);

/// The same if the word is like it, that is, if at least half its characters stay, leading dashes aside; else empty.
std::string_view nearest_alike(std::string_view word, std::span<const std::string_view> candidates);

/// What to say of a word that is none of the known ones, and the mend: `there is no strategy 'stak'; did you mean
/// stack? The strategies are stack, list`. `kind` is what one of them is called.
std::string no_such(std::string_view kind, std::string_view word, std::span<const std::string_view> known);
std::string no_such(std::string_view kind, std::string_view word, std::span<const std::string> known);

}  // namespace csgsim
