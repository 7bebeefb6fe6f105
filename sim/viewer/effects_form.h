#pragma once

#include <nlohmann/json.hpp>

namespace csgsim::viewer {

/// The effects that can be called for, as an array of `name`, `meaning`, `key`, what comes before the names of keys in
/// --set, `is_list`, and `keys`: `name`, `allowed`, `unit`, `usual`, `meaning`, and `choices`, if it is one of these.
nlohmann::ordered_json effects_form();

}  // namespace csgsim::viewer
