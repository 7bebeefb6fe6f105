#pragma once

#include <optional>
#include <string_view>

namespace csgsim::read {

/// The nearest double to a literal that the grammar takes (`-1.5e3`, `.5`, `inf`, `-nan`). What is too small for a
/// double becomes zero; nothing if it is too large.
std::optional<double> parse_number(std::string_view literal);

}  // namespace csgsim::read
