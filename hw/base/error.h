#pragma once

#include <stdexcept>
#include <string_view>

namespace csgsim {

/// Bad input: a model, machine file or Program that cannot be used. The text is one line for people, of the form
/// `file:line:column: what is wrong, and what to do` where there is a place to point at; what it quotes of the input is
/// made printable(). The command line exits with 1.
class InputError : public std::runtime_error {
 public:
  explicit InputError(std::string_view message);
};

}  // namespace csgsim
