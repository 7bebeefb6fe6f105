#pragma once

#include <unistd.h>

#include <algorithm>
#include <string>

#include "hw/base/standard_streams.h"
#include "sim/shell/command_line.h"

namespace csgsim::shell {

/// What is wrong with a name of a file or folder, or nothing.
inline std::string not_empty(const std::string& name) { return name.empty() ? "the name is empty; name a file" : ""; }

/// What is wrong with a count, or nothing. CLI11 by itself takes -1 for the greatest number.
inline std::string whole_number(const std::string& text) {
  const bool is_digits =
      !text.empty() && std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
  return is_digits ? "" : "'" + text + "' is not a whole number, 0 or more";
}

/// Whether to tell on standard error how far things are.
inline bool shows_progress(const std::string& progress) {
  return progress == "auto" && !is_silent() && ::isatty(STDERR_FILENO) != 0;
}

inline void add_progress(Command& command, std::string& progress) {
  command.option("--progress", progress, "auto (when standard error is a terminal) or none")
      .one_of({"auto", "none"}, "progress setting");
}

}  // namespace csgsim::shell
