#pragma once

#include <cstdint>
#include <span>

namespace csgsim::division {

/// Numbers and widths in bits at the beginning of a display model (docs/machines/pixel-square.md), read without its
/// divider.
struct ModelSizes {
  std::uint64_t planes = 0;
  std::uint64_t primitives = 0;
  std::uint64_t nodes = 0;
  std::uint32_t depth = 0;  ///< without the end of the range
  std::uint32_t colour = 0;
  std::uint32_t slope = 0;
  std::uint32_t constant = 0;
  std::uint32_t halfspaces = 0;  ///< the number of a primitive's
  std::uint32_t operands = 0;    ///< the number of an operator's
  std::uint32_t plane = 0;       ///< an index of a plane
};

/// All 0 where there are too few bytes.
ModelSizes sizes_of(std::span<const std::uint8_t> display_model);

}  // namespace csgsim::division
