#pragma once

#include <string>

#include "hw/isa/program.h"

namespace csgsim::testing {

/// The text form without the lines and keys that are for people, and without comments, origins among them. Fields stand
/// at their places, as the facts that name them are gone. For Programs without `;` or `#` in a string.
std::string bare_text(isa::Program program);

}  // namespace csgsim::testing
