#pragma once

#include <toml++/toml.h>

#include <string>

namespace csgsim::scene {

/// What comes before KEY=VALUE as the source of a node, instead of a file's name.
inline constexpr std::string_view set_mark = "--set ";

/// Puts a value given as KEY=VALUE into the scene. Throws SetError.
void set(toml::table& root, const std::string& key_and_value);

}  // namespace csgsim::scene
