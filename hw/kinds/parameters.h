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
std::string kinds_with(std::string_view key);

/// Why a machine of the kind cannot have that parameter of another kind changed, with its nearest parameter; empty if
/// it can. `name`: the machine's name.
std::string why_missing(std::string_view key, const machines::Kind& kind, std::string_view name);

}  // namespace csgsim::kinds
