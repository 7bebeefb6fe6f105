// Parameters of a machine's host.
// Used by machine.h.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace csgsim::machines {

/// Names of the values of Host::processor: first the processor without delay, then the built-in processors
/// (hw/processors).
inline constexpr auto host_processor_names = std::to_array<std::string_view>({"ideal", "i486dx2", "i860", "mc68000"});

/// Value of Host::processor for a host that compiles in no time.
inline constexpr std::uint32_t ideal_processor = 0;

/// The host that compiles the frames for a machine (docs/host.md).
struct Host {
  std::uint32_t processor = ideal_processor;  ///< index into host_processor_names
  std::uint32_t count = 1;                    ///< number of processors that share the work evenly

  constexpr bool operator==(const Host&) const = default;
};

}  // namespace csgsim::machines
