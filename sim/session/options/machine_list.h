#pragma once

#include <fmt/format.h>

#include <string>

#include "hw/kinds/load.h"

namespace csgsim::session {

/// The machines that studies of several draw on if none are named, as an option has them.
inline std::string all_machines() { return fmt::format("{}", fmt::join(kinds::studied_names(), ",")); }

/// All that come with csgsim, as an option has them.
inline std::string every_machine() { return fmt::format("{}", fmt::join(kinds::built_in_names(), ",")); }

}  // namespace csgsim::session
