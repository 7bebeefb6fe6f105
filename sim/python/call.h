#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/session/options/option_list.h"

namespace csgsim::python {

/// What a caller says: the operands, and options by their long names without dashes, each with its text, or none of a
/// flag.
struct Call {
  std::string command;
  std::vector<std::string> operands;
  std::vector<std::pair<std::string, std::optional<std::string>>> options;
};

/// Gives the options of the list what the call says, and takes them. Throws UsageError.
void give(const Call& call, session::OptionList& list);

/// The options and operands of a command, in the order of help, with their defaults. Throws UsageError for a command
/// that cannot be called.
std::vector<session::OptionValue> options_of(const std::string& command);

}  // namespace csgsim::python
