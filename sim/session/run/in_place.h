// Replaces a file by a text or Program in memory.
// Used by explain.h, render.h and run_file.h.
#pragma once

#include <optional>
#include <string>

#include "hw/isa/program.h"

namespace csgsim::session {

/// Replacement for the content of the named file, if any.
struct ContentReplacement {
  std::optional<std::string> text;        ///< text of a model
  const isa::Program* program = nullptr;  ///< must outlive the call
};

}  // namespace csgsim::session
