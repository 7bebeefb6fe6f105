#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::isa {

/// The text as a string of the text form: in quotes, on one line, control characters as \xNN.
std::string in_quotes(std::string_view text);

/// What stands between the quotes of a string, its escapes replaced.
std::string unescaped(std::string_view body);

/// The text bare if it is a word of the text form, else quoted.
std::string word_or_quoted(std::string_view text);

/// Two digits a byte.
std::string hexadecimal(std::span<const std::uint8_t> bytes);

/// Of such digits; none, if they are not.
std::optional<std::vector<std::uint8_t>> bytes_of(std::string_view digits);

}  // namespace csgsim::isa
