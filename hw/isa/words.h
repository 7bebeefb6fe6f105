#pragma once

#include <string>
#include <string_view>

namespace csgsim::isa {

/// The text as a string of the text form: in quotes, on one line, control characters as \xNN.
std::string quoted(std::string_view text);

/// What stands between the quotes of a string, its escapes replaced.
std::string unescaped(std::string_view body);

/// The text bare if it is a word of the text form, else quoted.
std::string word_or_quoted(std::string_view text);

}  // namespace csgsim::isa
