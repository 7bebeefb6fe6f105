// UTF-8 characters of a text.
// Used to measure texts and to check that fonts have their glyphs.
#pragma once

#include <string_view>
#include <vector>

namespace csgsim::plots {

/// Splits a printable text into characters; each view holds the bytes of one.
std::vector<std::string_view> split_characters(std::string_view text);

/// The Unicode code point of one character.
char32_t code_point(std::string_view character);

}  // namespace csgsim::plots
