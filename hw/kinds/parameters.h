// Parameters of machines, by their keys in all kinds.
// Used by load.cpp and sim/session.
#pragma once

#include <string>
#include <string_view>

#include "hw/machines/kind.h"

namespace csgsim::kinds {

/// Key of a change `KEY=VALUE`.
std::string_view key_of(std::string_view change);

bool has_parameter(const machines::Kind& kind, std::string_view key);

/// Whether any kind of machine has the parameter.
bool is_parameter(std::string_view key);

/// Names of the kinds of machines that have the parameter, separated by commas.
std::string names_of_kinds_with(std::string_view key);

/// Error text for a change of a parameter that only other kinds of machines have: names these kinds, and the nearest
/// parameter of `kind` if one is similar. Empty if `kind` has the parameter. `machine_name`: for the message.
std::string missing_parameter_text(std::string_view key, const machines::Kind& kind, std::string_view machine_name);

}  // namespace csgsim::kinds
