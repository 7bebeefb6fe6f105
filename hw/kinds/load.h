#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::kinds {

/// Names of the machines that come with csgsim.
std::vector<std::string_view> built_in_names();

/// The file that describes the machine; empty if it is built in.
std::string_view file_of(std::string_view machine);

/// A built-in machine by name, or one described in a file (anything ending in .toml). Figures may be changed behind it:
/// `NAME+KEY=VALUE+KEY=VALUE`; a file whose own name has a plus sign takes no changes. Throws InputError: an unknown
/// name (with the nearest one), unknown key, wrong type, value out of range, each with file:line:column.
machines::Machine load(const std::string& machine);

}  // namespace csgsim::kinds
