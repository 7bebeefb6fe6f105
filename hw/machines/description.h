#pragma once

#include <string_view>

#include "hw/machines/machine.h"

namespace csgsim::machines {

/// Reads a description (TOML); `file` is its name in messages. Throws InputError, with file:line:column.
Machine read_description(std::string_view text, std::string_view file);

}  // namespace csgsim::machines
