#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace csgsim::shell {

/// What an option or operand names, whatever command has it.
enum class FileRole : std::uint8_t {
  none,      ///< no file
  input,     ///< a file or folder that is read
  output,    ///< a file or folder that is written, or a checkpoint, of which a run does not depend
  machines,  ///< machines by name or file, with commas where the option takes several
};

/// Of a long option's name without dashes, or an operand's in small letters.
FileRole role_of(std::string_view option);

/// The option's value as it is where relative names of files are relative to that folder; standard streams, `-`, and
/// what names no file stay as they are.
std::string in_folder(std::string_view option, const std::string& value, const std::string& folder);

}  // namespace csgsim::shell
