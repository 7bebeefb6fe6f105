// Operation counts of the divider, and its peak memory. Used by hw/multi_processor and host/emit.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>

#include "hw/isa/host_counts.h"
#include "hw/isa/program.h"

namespace csgsim::division {

/// Operations of the divider for a surface, a square, or a group of squares.
using Counts = isa::DivisionStep;

/// Peak memory of the divider: the maximum over the surfaces of a square.
struct PeakUsage {
  std::uint64_t halfspaces = 0;  ///< half-spaces tested at corners
  std::uint64_t nodes = 0;       ///< visits of tree nodes for one surface

  bool operator==(const PeakUsage&) const = default;
};

/// Peak memory over the given surfaces.
inline PeakUsage peak_usage_of(std::span<const Counts> surfaces) {
  PeakUsage peak;
  for (const Counts& surface : surfaces) {
    peak.halfspaces = std::max(peak.halfspaces, surface.halfspaces);
    peak.nodes = std::max(peak.nodes, surface.nodes);
  }
  return peak;
}

}  // namespace csgsim::division
