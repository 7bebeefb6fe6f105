// Replaces names in templates.
// Used by board.h and design.cpp.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace csgsim::rtl {

/// The text that replaces @NAME@ in a template.
struct Filling {
  std::string_view name;
  std::string value;
};

/// Replaces every @NAME@, in capitals. Throws std::logic_error for a name without a filling.
std::string fill_template(std::string_view text, std::span<const Filling> fillings);

}  // namespace csgsim::rtl
