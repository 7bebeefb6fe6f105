#pragma once

#include "sim/shell/manual/description.h"

namespace CLI {
class App;
}

namespace csgsim::shell {

// Names of the checks that tell which words, and which numbers, an option takes.
inline constexpr const char* words_check = "words";
inline constexpr const char* range_check = "range";

/// The group of options that no help shows.
inline constexpr const char* hidden_group = "Hidden";

/// What the library that reads the command line knows of a command.
CommandHelp help_of_command(CLI::App& command);

/// The same of all.
Description describe(CLI::App& app);

}  // namespace csgsim::shell
