// Data of the page's form of effects.
// Used by session.cpp.
#pragma once

#include <nlohmann/json.hpp>

namespace csgsim::viewer {

/// The available effects as an array of objects with `name`, `meaning`, `key` (the prefix of their keys in --set),
/// `is_list`, and `keys`: `name`, `allowed`, `unit`, `usual` (the default), `meaning`, and `choices` if the values are
/// fixed words.
nlohmann::ordered_json effects_form();

}  // namespace csgsim::viewer
