// Headings, placeholders and file roles of all options.
// Used by sim/app, sim/python, sim/session and sim/shell.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace csgsim::session {

/// Role of the file that an option or operand names; the same for every command.
enum class FileRole : std::uint8_t {
  none,        ///< no file
  input,       ///< a file or folder that is read
  output,      ///< a file or folder that is written; or a checkpoint, which does not affect the result of a run
  machines,    ///< machines by name or file, separated by commas where the option takes several
  processors,  ///< processors by name or file, separated by commas
  processes,   ///< a process by name or file
};

/// Properties of an option or operand that are the same for every command.
struct KnownOption {
  std::string_view subject;  ///< heading in help
  std::string_view name{};   ///< first long name without dashes, or an operand's name in lower case
  std::string_view value{};  ///< placeholder of its value in help; empty: by its type
  FileRole role = FileRole::none;
};

/// The entry of an option; options outside the table (option_table.cpp) share one entry. NAME-a and NAME-b, of one side
/// of a comparison, have the entry of NAME.
const KnownOption& known_option(std::string_view option);

/// Position of a heading in help.
int heading_position(std::string_view subject);

/// The option's value, with relative file names moved into that folder. `-` and values that name no file stay
/// unchanged.
std::string resolve_in_folder(std::string_view option, const std::string& value, const std::string& folder);

}  // namespace csgsim::session
