// The exception for bad input.
// Used in all rooms.
#pragma once

#include <stdexcept>
#include <string_view>

namespace csgsim {

/// Bad input: a model, machine file or Program that cannot be used. The text is one line of the form `file:line:column:
/// what is wrong; what to do`; unknown parts of the position are omitted. The constructor escapes quoted input with
/// printable(). The command line exits with 1.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string_view message);
};

}  // namespace csgsim
