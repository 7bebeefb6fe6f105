// Reads machine descriptions.
// Used by hw/kinds and sim/session.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "hw/machines/change_error.h"
#include "hw/machines/kind.h"

namespace csgsim::machines {

/// Reads a description (TOML) of a machine of one of `kinds`; `file` is its name in messages. Throws InputError with
/// file:line:column. Each of `changes`, KEY=VALUE, then replaces a parameter's value, whose provenance becomes
/// `assumed`. The machine's name lists the changes, `NAME+KEY=VALUE`, each parameter once with its last value. Throws
/// ChangeError for a wrong change.
Machine read_description(std::string_view text, std::string_view file, std::span<const Kind* const> kinds,
                         std::span<const std::string> changes = {});

}  // namespace csgsim::machines
