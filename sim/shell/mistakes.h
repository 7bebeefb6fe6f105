// Explains command lines that cannot be read.
// Used by command_line.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "sim/session/options/option_list.h"

namespace csgsim::shell {

/// The message about a command line that begins with none of `commands`: what is wrong and what to write. The first
/// argument is the program's name.
std::string unknown_command_message(std::span<const std::string> arguments, std::span<const std::string> commands);

/// The message about an option whose value is missing, because it is the last word or an option follows. Empty if no
/// value is missing. `words` follow the command's name.
std::string missing_value_message(const session::OptionList& command, std::span<const std::string> words);

/// The message about the first of the words after the command's name that is an unknown option or a surplus operand.
/// Empty if there is none.
std::string unreadable_word_message(const session::OptionList& command, std::span<const std::string> words);

/// The message, followed by the command that prints the help, unless the message names one.
std::string with_help_hint(const std::string& message, std::string_view command);

}  // namespace csgsim::shell
