#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "hw/kinds/load.h"

namespace csgsim::shell {

/// Memories of today that compute: a frame of theirs is millions of row commands, so that they have to be named.
inline constexpr auto memories_of_today =
    std::to_array<std::string_view>({"ambit-ddr4", "simdram-ddr4", "digital-bit-serial-ddr4"});

/// The machines that studies of several draw on if none are named: all others that come with csgsim, as an option has
/// them.
inline std::string all_machines() {
  std::string all;
  for (const std::string_view name : kinds::built_in_names()) {
    if (std::ranges::find(memories_of_today, name) != memories_of_today.end()) continue;
    all += (all.empty() ? "" : ",") + std::string(name);
  }
  return all;
}

/// All that come with csgsim, as an option has them.
inline std::string every_machine() {
  std::string every = all_machines();
  for (const std::string_view name : memories_of_today) every += "," + std::string(name);
  return every;
}

}  // namespace csgsim::shell
