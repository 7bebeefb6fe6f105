#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "hw/machines/machine.h"

namespace csgsim::kinds {

/// Names of the machines that come with csgsim.
std::vector<std::string_view> built_in_names();

/// Does the name stand for a file that describes a machine?
bool is_file(std::string_view name_or_file);

/// A built-in machine by name, or one described in a file (anything ending in .toml). Throws InputError: an unknown
/// name (with the nearest one), unknown key, wrong type, value out of range, each with file:line:column.
machines::Machine load(const std::string& name_or_file);

}  // namespace csgsim::kinds
