// Parser of number literals.
// Used by parser.cpp, restore.cpp and host/commands.
#pragma once

#include <optional>
#include <string_view>

namespace csgsim::read {

/// The double nearest to a literal of the grammar (`-1.5e3`, `.5`, `inf`, `-nan`). Literals below the range of doubles
/// become 0; the result is empty for those above it.
std::optional<double> parse_number(std::string_view literal);

}  // namespace csgsim::read
