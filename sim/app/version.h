#pragma once

#include <string>

namespace csgsim::app {

/// The program's version and what the linker calls this build, as in `0.1.0 3f2a...`: different code has a different
/// text.
std::string version_and_build();

}  // namespace csgsim::app
