#pragma once

#include "tests/support/test.h"

namespace csgsim::testing {

/// Returns `my.toml:line:column` of the first occurrence of the needle in the text.
inline std::string place_in(std::string_view text, std::string_view needle) {
  const std::size_t at = text.find(needle);
  REQUIRE(at != std::string_view::npos);
  const std::string_view before = text.substr(0, at);
  return fmt::format("my.toml:{}:{}", 1 + std::ranges::count(before, '\n'), at - before.rfind('\n'));
}

}  // namespace csgsim::testing
