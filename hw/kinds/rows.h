#pragma once

#include <span>
#include <string_view>

#include "hw/machines/kind.h"

namespace csgsim::kinds {

/// Every kind of machine that comes with csgsim.
std::span<const machines::Kind* const> all();

/// A machine description that comes with csgsim.
struct BuiltIn {
  std::string_view name;
  std::string_view text;  ///< of NAME.toml
};

std::span<const BuiltIn> built_in();

/// Names of those on which studies of several machines draw only where they are named.
std::span<const std::string_view> costly();

}  // namespace csgsim::kinds
