#pragma once

#include <stdexcept>
#include <string>

namespace csgsim {

/// Bad input: a model, machine file or Program that cannot be used. The text is one line for people, of the form
/// `file:line:column: what is wrong, and the mend` where there is a place to point at. The command line exits with 1.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace csgsim
