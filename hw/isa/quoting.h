// Quoted strings and hexadecimal digits of the text form.
// Used by hw/isa and sim/debug.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::isa {

/// The text as a quoted string of the text form, on one line, with control characters as \xNN.
std::string quote_text(std::string_view text);

/// The body of a quoted string with its escapes replaced.
std::string unescaped(std::string_view body);

/// The text unchanged if it is a word of the text form, otherwise quoted.
std::string word_or_quoted(std::string_view text);

/// Two hexadecimal digits per byte.
std::string hexadecimal(std::span<const std::uint8_t> bytes);

/// The inverse of hexadecimal(); nullopt if `digits` are not hexadecimal, two per byte.
std::optional<std::vector<std::uint8_t>> parse_hexadecimal(std::string_view digits);

}  // namespace csgsim::isa
