#pragma once

#include <span>
#include <string>
#include <string_view>

namespace csgsim::rtl {

/// What stands in a template's @NAME@.
struct Filling {
  std::string_view name;
  std::string value;
};

/// The text with every @NAME@, in capitals, replaced. Throws std::logic_error for one that has no filling.
std::string filled(std::string_view text, std::span<const Filling> fillings);

}  // namespace csgsim::rtl
