// Default lists of machines for options.
// Used by sim/app and sim/studies.
#pragma once

#include <fmt/format.h>

#include <string>

#include "hw/kinds/load.h"

namespace csgsim::session {

/// The machines that studies of several machines compare by default, as the text of an option.
inline std::string studied_machines_text() { return fmt::format("{}", fmt::join(kinds::studied_names(), ",")); }

/// All built-in machines, as the text of an option.
inline std::string built_in_machines_text() { return fmt::format("{}", fmt::join(kinds::built_in_names(), ",")); }

}  // namespace csgsim::session
