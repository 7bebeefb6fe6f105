// The exception for invalid requests.
// Used by sim/session, sim/app, sim/python, sim/shell, sim/studies and sim/viewer.
#pragma once

#include <stdexcept>
#include <string>

#include "hw/base/text.h"

namespace csgsim::session {

/// A request is invalid; what() explains why in one line. The constructor escapes quoted input with printable().
class UsageError : public std::runtime_error {
 public:
  explicit UsageError(const std::string& message) : std::runtime_error(printable(message)) {}
  UsageError(const std::string& option, const std::string& message) : UsageError(option + ": " + message) {}
};

}  // namespace csgsim::session
