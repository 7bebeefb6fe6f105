#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <vector>

#include "sim/shell/command_line.h"
#include "sim/shell/manual/help.h"

namespace csgsim::shell {

/// What stands behind an option, or in an operand's place.
enum class ValueKind : std::uint8_t {
  none,        ///< nothing: a flag
  words,       ///< one of its words, or a text that is made of them
  file,        ///< a file or folder
  machines,    ///< a machine's name or its file
  processors,  ///< a processor's name or its file
  text,        ///< any other text, or a number
};

ValueKind kind_of(const OptionHelp& option);

/// Words that a shell may offer for the value: those that it takes, or the machines or processors; none if it takes any
/// text.
std::vector<std::string> offered_words(const OptionHelp& option);

/// Does a shell offer files for the value?
bool offers_files(const OptionHelp& option);

/// The whole command line, without what help hides.
struct Description {
  std::string program;
  std::string meaning;
  std::string version;
  std::string date;  ///< of the sources, as in 2001-12-31
  std::vector<OptionHelp> options;
  std::vector<CommandHelp> commands;
};

CommandHelp help_of_command(const Command& command);
std::vector<CommandHelp> helps_of(const std::deque<Command>& commands);

Description describe(const std::string& program, const std::string& meaning, const std::deque<Command>& commands);

/// A file that is made from the description.
struct DescriptionFile {
  std::string name;
  std::string content;
};

/// `NAME.1` and `NAME-COMMAND.1`, pages for man.
std::vector<DescriptionFile> manual_pages(const Description& description);

// Completion for the shells.
std::string bash_completion(const Description& description);
std::string zsh_completion(const Description& description);
std::string fish_completion(const Description& description);

/// Writes all of them to the folder, which is made if it is not there. Throws InputError.
void write_description(const Description& description, const std::string& folder);

}  // namespace csgsim::shell
