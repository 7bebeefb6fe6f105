// Formats help texts.
// Used by command_line.cpp and description.h.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace csgsim::shell {

/// Maximum line length of help.
inline constexpr std::size_t help_columns = 80;

/// Placeholder in help for an option that names a folder.
inline constexpr const char* folder_type = "FOLDER";

/// An option or an operand in help. Texts may be empty.
struct OptionHelp {
  std::vector<std::string> names;  ///< names with dashes, short ones first; one name for an operand
  std::string type;                ///< type of the value: TEXT, UINT, FLOAT, folder_type; empty for a flag
  std::string meaning;
  std::vector<std::string> words;  ///< accepted words; empty if any text is accepted
  std::string range;               ///< range of its numbers
  std::string usual;               ///< default value
  bool is_needed = false;          ///< the command requires it
  bool takes_several = false;
};

/// A command in help.
struct CommandHelp {
  std::string name;
  std::string subject;  ///< heading of its group
  std::string meaning;
  std::string footer;  ///< examples, which begin with two blanks, and remarks
  std::vector<OptionHelp> operands;
  std::vector<OptionHelp> options;
};

/// The options under one heading (option_table.h).
struct SubjectHelp {
  std::string_view subject;
  std::vector<const OptionHelp*> options;
};

/// Groups a command's options by heading, in the order of help.
std::vector<SubjectHelp> group_by_subject(std::span<const OptionHelp> options);

/// Placeholder of an option's value in help: `FILE`, `N`; empty for a flag.
std::string value_placeholder(const OptionHelp& option);

/// The first long name without dashes; empty if there is none.
std::string long_name(const OptionHelp& option);

/// Wraps a footer. Commands continue after a backslash, as in a shell; consecutive remarks form one paragraph.
std::string wrap_footer(std::string_view footer, std::size_t columns);

/// Text of `csgsim COMMAND --help`: options by heading, no line longer than help_columns.
std::string help_text(const CommandHelp& command);

/// Text of `csgsim --help`: commands by group.
std::string overview_text(const std::string& meaning, std::span<const CommandHelp> commands);

}  // namespace csgsim::shell
