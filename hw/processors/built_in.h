#pragma once

#include <span>
#include <string_view>

namespace csgsim::processors {

/// A processor's description that comes with csgsim.
struct BuiltInProcessor {
  std::string_view name;
  std::string_view text;  ///< of NAME.toml
};

std::span<const BuiltInProcessor> built_in_processors();

}  // namespace csgsim::processors
