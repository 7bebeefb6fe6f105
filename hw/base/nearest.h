#pragma once

#include <cstddef>
#include <span>
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

}  // namespace csgsim
