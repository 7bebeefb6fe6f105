#pragma once

#include <span>
#include <string_view>

namespace csgsim::process {

/// A process's description that comes with csgsim.
struct BuiltInProcess {
  std::string_view name;
  std::string_view text;  ///< of NAME.toml
};

std::span<const BuiltInProcess> built_in_processes();

}  // namespace csgsim::process
