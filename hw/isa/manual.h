// Generates the manual of the instruction set.
// Used by sim/app.
#pragma once

#include <string>

namespace csgsim::isa {

/// The manual of the instruction set in Markdown, generated from the tables that the code uses:
/// docs/instruction-set.md.
std::string instruction_set_page();

}  // namespace csgsim::isa
