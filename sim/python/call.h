// Converts Python calls to requests.
// Used by module.cpp.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/session/options/option_list.h"

namespace csgsim::python {

/// A call from Python: the operands, and the options by their long names without dashes, each with its text (empty for
/// a flag).
struct Call {
  std::string command;
  std::vector<std::string> operands;
  std::vector<std::pair<std::string, std::optional<std::string>>> options;
};

/// Sets the operands and options of the list from the call. Throws UsageError.
void give(const Call& call, session::OptionList& options);

/// The options and operands of a command, in the order of help, with their defaults. Throws UsageError for an unknown
/// call.
std::vector<session::OptionValue> command_options(const std::string& command);

}  // namespace csgsim::python
