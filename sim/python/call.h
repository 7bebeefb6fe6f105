#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim/shell/command_line.h"

namespace csgsim::python {

/// What a caller says: the operands, and options by their long names without dashes, each with its text, or none of a
/// flag.
struct Call {
  std::string command;
  std::vector<std::string> operands;
  std::vector<std::pair<std::string, std::optional<std::string>>> options;
};

/// Adds the command that is called to the line, with what it does.
using Describe = std::function<void(shell::CommandLine& line)>;

/// Reads the call as the command line reads its words, and does what `describe` says. Throws UsageError, and what
/// `describe` throws.
void carry_out(const Call& call, const Describe& describe);

/// The options and operands of a command, in the order of help, with their defaults. Throws UsageError
/// for a command that cannot be called.
std::vector<shell::OptionValue> options_of(const std::string& command);

}  // namespace csgsim::python
