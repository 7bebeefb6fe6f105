// Default lists of machines for options.
// Used by sim/app and sim/studies.
#pragma once

#include <fmt/format.h>

#include <string>

#include "hw/kinds/load.h"

namespace csgsim::session {

/// Names of the machines that studies of several machines compare by default, separated by commas.
inline std::string studied_machines_text() { return fmt::format("{}", fmt::join(kinds::studied_names(), ",")); }

/// Names of all built-in machines, separated by commas.
inline std::string built_in_machines_text() { return fmt::format("{}", fmt::join(kinds::built_in_names(), ",")); }

}  // namespace csgsim::session
