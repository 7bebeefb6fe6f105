// The option --progress.
// Used by sim/session, sim/shell, sim/app and sim/studies.
#pragma once

#include <unistd.h>

#include <string>

#include "hw/base/standard_streams.h"
#include "sim/session/options/option_list.h"

namespace csgsim::session {

/// Whether to show progress on standard error.
inline bool shows_progress(const std::string& progress) {
  return progress == "auto" && !is_silent() && ::isatty(STDERR_FILENO) != 0;
}

/// Adds --progress.
inline void add_progress_option(OptionList& command, std::string& progress) {
  command.option("--progress", progress, "Show progress: auto (if standard error is a terminal) or none")
      .one_of({"auto", "none"}, "progress setting");
}

}  // namespace csgsim::session
