// Scene values set on the command line.
// Used by read.cpp.
#pragma once

#include <toml++/toml.h>

#include <string>

namespace csgsim::scene {

/// Prefix of the position of a value given as KEY=VALUE, in place of a file name.
inline constexpr std::string_view set_mark = "--set ";

/// Stores a value given as KEY=VALUE in the scene. Throws SetError.
void set(toml::table& root, const std::string& key_and_value);

}  // namespace csgsim::scene
