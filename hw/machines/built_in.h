// A built-in description: a name and its file. Used by catalogue.h, hw/kinds, hw/processors and hw/process.
#pragma once

#include <string_view>

namespace csgsim::machines {

struct BuiltIn {
  std::string_view name;
  std::string_view text;  ///< content of NAME.toml
};

}  // namespace csgsim::machines
