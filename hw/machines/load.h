#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hw/machines/accounts.h"

namespace csgsim::machines {

/// How much a part of a machine has to do for a frame.
struct Load {
  std::string part;          ///< for people, as `link from the host`
  std::string_view does;     ///< while it works, as `sends`
  std::uint64_t clocks = 0;  ///< in which it works
};

/// Clocks that a part spent on an activity; 0 where the account does not tell of them.
std::uint64_t clocks_of(const Account& account, std::string_view part, std::string_view activity);

}  // namespace csgsim::machines
