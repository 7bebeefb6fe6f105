#pragma once

#include <span>
#include <string_view>

namespace csgsim::machines {

/// A machine description that comes with csgsim.
struct BuiltIn {
  std::string_view name;
  std::string_view text;  ///< of NAME.toml
};

std::span<const BuiltIn> built_in();

}  // namespace csgsim::machines
