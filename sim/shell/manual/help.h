#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::shell {

/// Columns that no line of a help goes beyond.
inline constexpr std::size_t help_columns = 80;

/// What help calls the value of an option that names a folder.
inline constexpr const char* folder_type = "FOLDER";

/// An option or an operand as help tells of it. Texts may be empty.
struct OptionHelp {
  std::vector<std::string> names;  ///< with dashes, the short one first; of an operand its only one
  std::string type;                ///< what is given: TEXT, UINT, FLOAT, folder_type; none for a flag
  std::string meaning;
  std::vector<std::string> words;  ///< that it takes; none if it takes any
  std::string range;               ///< of its numbers
  std::string usual;               ///< what it is if it is not given
  bool is_needed = false;          ///< the command does nothing without it
  bool takes_several = false;
};

/// A command as help tells of it.
struct CommandHelp {
  std::string name;
  std::string subject;
  std::string meaning;
  std::string footer;  ///< examples, which begin with two blanks, and remarks
  std::vector<OptionHelp> operands;
  std::vector<OptionHelp> options;
};

/// The options of one subject (option_subjects.h).
struct SubjectHelp {
  std::string_view subject;
  std::vector<const OptionHelp*> options;
};

/// A command's options in the order of help.
std::vector<SubjectHelp> by_subject(std::span<const OptionHelp> options);

/// What help calls the value of an option: `FILE`, `N`; empty of a flag.
std::string value_name(const OptionHelp& option);

/// The first long name without dashes, empty if there is none.
std::string long_name(const OptionHelp& option);

/// A footer with no line beyond the columns: its commands go on behind a backslash, as a shell takes them; remarks that
/// follow each other are one text.
std::string footer_lines(std::string_view footer, std::size_t columns);

/// What `csgsim COMMAND --help` prints: options by subject (option_subjects.h), no line longer than help_columns.
std::string help_of(const CommandHelp& command);

/// What `csgsim --help` prints: the commands by subject.
std::string help_of_all(const std::string& meaning, std::span<const CommandHelp> commands);

}  // namespace csgsim::shell
