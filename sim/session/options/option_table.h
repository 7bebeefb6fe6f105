#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace csgsim::session {

/// What an option or operand names, whatever command has it.
enum class FileRole : std::uint8_t {
  none,        ///< no file
  input,       ///< a file or folder that is read
  output,      ///< a file or folder that is written, or a checkpoint, of which a run does not depend
  machines,    ///< machines by name or file, with commas where the option takes several
  processors,  ///< the same of processors
  processes,   ///< one of processes
};

/// What is known of an option or operand beside what its command says.
struct KnownOption {
  std::string_view subject;  ///< under which help has it
  std::string_view name{};   ///< its first long name without dashes, or an operand's in small letters
  std::string_view value{};  ///< what help calls its value; empty: by its type
  FileRole role = FileRole::none;
};

/// One for all that are not in the table (option_table.cpp). NAME-a and NAME-b, of one side of a comparison, are as
/// NAME.
const KnownOption& known_option(std::string_view option);

/// The place of a subject in help.
int place_of_subject(std::string_view subject);

/// The option's value as it is where relative names of files are relative to that folder; standard streams, `-`, and
/// what names no file stay as they are.
std::string in_folder(std::string_view option, const std::string& value, const std::string& folder);

}  // namespace csgsim::session
