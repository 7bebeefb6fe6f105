#pragma once

#include <span>
#include <string_view>

#include "hw/machines/kind.h"

namespace csgsim::machines {

/// Reads a description (TOML) of a machine of one of the kinds; `file` is its name in messages. Throws InputError, with
/// file:line:column.
Machine read_description(std::string_view text, std::string_view file, std::span<const Kind* const> kinds);

}  // namespace csgsim::machines
