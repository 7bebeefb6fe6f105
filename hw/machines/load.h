// Work of the parts of a machine; the busiest part limits the frame rate. Used by Kind and its implementations.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "hw/machines/accounts.h"

namespace csgsim::machines {

/// Work of a part of a machine for one frame.
struct Load {
  std::string part;          ///< name for users, such as `link from the host`
  std::uint64_t clocks = 0;  ///< clocks in which it works
};

/// Clocks that a part spent in an activity; 0 if the account does not list it.
std::uint64_t clocks_of(const Account& account, std::string_view part, std::string_view activity);

}  // namespace csgsim::machines
