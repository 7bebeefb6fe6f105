#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

/// TOML that people write. The header behind this one takes seconds to compile: for source files.
namespace csgsim {

/// What a node is, as messages say it: "an integer".
std::string_view type_name(const toml::node& node);

/// `file:line:column` of a place in a text; before its first character is 1:1.
std::string show(const toml::source_position& place, std::string_view file);

/// Throws InputError that says where the text is no TOML; `file` is its name in messages.
toml::table parse_toml(std::string_view text, std::string_view file);

}  // namespace csgsim
