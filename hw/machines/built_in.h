#pragma once

#include <string_view>

namespace csgsim::machines {

/// A description that comes with csgsim.
struct BuiltIn {
  std::string_view name;
  std::string_view text;  ///< of NAME.toml
};

}  // namespace csgsim::machines
