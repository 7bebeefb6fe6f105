#pragma once

#include <optional>
#include <string>

#include "hw/isa/program.h"

namespace csgsim::session {

/// What stands in the place of the file that is named, if anything.
struct InPlace {
  std::optional<std::string> text;        ///< of a model
  const isa::Program* program = nullptr;  ///< that has to outlive the call
};

}  // namespace csgsim::session
