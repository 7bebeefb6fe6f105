// Parameters of a machine's host.
// Used by machine.h, hw/processors and hw/multi_processor.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace csgsim::machines {

/// Names of the built-in processors (hw/processors), for parameters that name one.
inline constexpr auto processor_names =
    std::to_array<std::string_view>({"i486dx2", "i860", "mc68000", "mc68020-weitek", "vax-780"});

/// Value of Host::processor for a host that compiles in no time.
inline constexpr std::uint32_t ideal_processor = 0;

/// Names of the values of Host::processor: the processor without delay, then the built-in processors.
inline constexpr auto host_processor_names = [] {
  std::array<std::string_view, processor_names.size() + 1> names{"ideal"};
  for (std::size_t i = 0; i < processor_names.size(); ++i) names[i + 1] = processor_names[i];
  return names;
}();

/// The host that compiles the frames for a machine (docs/host.md).
struct Host {
  std::uint32_t processor = ideal_processor;  ///< index into host_processor_names
  std::uint32_t count = 1;                    ///< number of processors that share the work (hw/host/shares.h)

  constexpr bool operator==(const Host&) const = default;
};

}  // namespace csgsim::machines
