#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace csgsim::app {

/// Columns that no line of a help goes beyond.
inline constexpr std::size_t help_columns = 80;

/// An option or an operand as help tells of it. Texts may be empty.
struct OptionHelp {
  std::vector<std::string> names;  ///< with dashes, the short one first; of an operand its only one
  std::string type;                ///< what is given: TEXT, UINT, FLOAT; none for a flag
  std::string meaning;
  std::string words;       ///< that it takes, with commas
  std::string range;       ///< of its numbers
  std::string usual;       ///< what it is if it is not given
  bool is_needed = false;  ///< the command does nothing without it
  bool takes_several = false;
};

/// A command as help tells of it.
struct CommandHelp {
  std::string name;
  std::string meaning;
  std::string footer;  ///< examples, which begin with two blanks, and remarks
  std::vector<OptionHelp> operands;
  std::vector<OptionHelp> options;
};

/// What `csgsim COMMAND --help` prints: options by subject (option_subjects.h), no line longer than help_columns.
std::string help_of(const CommandHelp& command);

/// What `csgsim --help` prints: the commands by subject.
std::string help_of_all(const std::string& meaning, std::span<const CommandHelp> commands);

}  // namespace csgsim::app
