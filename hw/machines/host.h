#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::machines {

/// What Host::processor counts: the processors that come with csgsim (hw/processors), behind the one that takes no
/// time.
inline constexpr auto host_processor_names = std::to_array<std::string_view>({"ideal", "i486dx2", "i860", "mc68000"});

/// As Host::processor: compiling takes no time.
inline constexpr std::uint32_t ideal_processor = 0;

/// Who compiles the frames that a machine draws (docs/host.md).
struct Host {
  std::uint32_t processor = ideal_processor;  ///< which of host_processor_names
  std::uint32_t count = 1;                    ///< processors that share the work evenly

  constexpr bool operator==(const Host&) const = default;
};

}  // namespace csgsim::machines
