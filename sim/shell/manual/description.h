// Description of the command line for manual pages and shell completion.
// Used by command_line.cpp, completion.cpp and manual_pages.cpp.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "sim/shell/command_line.h"
#include "sim/shell/manual/help.h"

namespace csgsim::shell {

/// Kind of an option's value or of an operand.
enum class ValueKind : std::uint8_t {
  none,        ///< no value: a flag
  words,       ///< one of its words, or a text composed of them
  file,        ///< a file or folder
  machines,    ///< a machine's name or its file
  processors,  ///< a processor's name or its file
  text,        ///< any other text, or a number
};

ValueKind value_kind(const OptionHelp& option);

/// Words that a shell offers for the value: its own words, or the machines or processors; empty if any text is
/// accepted.
std::vector<std::string> completion_words(const OptionHelp& option);

/// Whether a shell offers files for the value.
bool offers_files(const OptionHelp& option);

/// Description of the whole command line, without hidden options.
struct Description {
  std::string program;
  std::string meaning;
  std::string version;
  std::string date;  ///< date of the sources, as in 2001-12-31
  std::vector<OptionHelp> options;
  std::vector<CommandHelp> commands;
};

CommandHelp make_help(const Command& command);
std::vector<CommandHelp> make_command_helps(const std::deque<Command>& commands);

Description describe(const std::string& program, const std::string& meaning, const std::deque<Command>& commands);

/// A file generated from the description.
struct DescriptionFile {
  std::string name;
  std::string content;
};

/// Manual pages `NAME.1` and `NAME-COMMAND.1`.
std::vector<DescriptionFile> manual_pages(const Description& description);

// Completion scripts of the shells.
std::string bash_completion(const Description& description);
std::string zsh_completion(const Description& description);
std::string fish_completion(const Description& description);

/// Writes all files to the folder, which is created if missing. Throws InputError.
void write_description(const Description& description, const std::string& folder);

}  // namespace csgsim::shell
