// Parses TOML with errors at their position.
// Used by hw/bit_serial_memory, hw/machines, host/scene, sim/shell and sim/suite.
#pragma once

#include <toml++/toml.h>

#include <string>
#include <string_view>

// TOML files written by users. toml++ takes seconds to compile: include this header in source files only.
namespace csgsim {

/// The type of a node for messages, with its article: "an integer".
std::string_view type_name(const toml::node& node);

/// `file:line:column` of a position in a text; a position before the first character is shown as 1:1.
std::string position_text(const toml::source_position& position, std::string_view file);

/// Throws InputError with the position of the first syntax error; `file` is the name in messages.
toml::table parse_toml(std::string_view text, std::string_view file);

}  // namespace csgsim
