// Table of the commands that are not studies.
// Used by main() and by the file of each command.
#pragma once

#include <span>
#include <string_view>

#include "sim/session/options/command_group.h"
#include "sim/shell/command_line.h"

namespace csgsim::app {

using namespace session;
using namespace shell;

/// A row of the table of commands. Studies have their own table (sim/studies/rows.h).
struct CommandRow {
  std::string_view name;
  void (*add)(CommandLine& line) = nullptr;  ///< adds the command to the command line
  bool needs_all_commands = false;           ///< the command runs or describes other commands
};

/// The commands, in the order of help.
std::span<const CommandRow* const> commands();

}  // namespace csgsim::app
