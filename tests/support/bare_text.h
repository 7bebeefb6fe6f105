#pragma once

#include <string>

#include "hw/isa/program.h"

namespace csgsim::testing {

/// Text form without human-readable lines and keys and without comments and origins. Fields appear as addresses because
/// the facts that name them are removed. Valid only for Programs without `;` or `#` in a string.
std::string bare_text(isa::Program program);

}  // namespace csgsim::testing
