// Counts and widths from the header of an encoded display model.
// Used by hw/multi_processor and hw/pixel_square.
#pragma once

#include <cstdint>
#include <span>

namespace csgsim::division {

/// Counts and widths in bits from the header of a display model (docs/machines/pixel-square.md), read without decoding
/// it.
struct ModelSizes {
  std::uint64_t planes = 0;
  std::uint64_t primitives = 0;
  std::uint64_t nodes = 0;
  std::uint32_t depth = 0;  ///< width of a depth step, excluding the end of the range
  std::uint32_t colour = 0;
  std::uint32_t slope = 0;
  std::uint32_t constant = 0;
  std::uint32_t halfspaces = 0;  ///< width of the number of a primitive's half-spaces
  std::uint32_t operands = 0;    ///< width of the number of an operator's operands
  std::uint32_t plane = 0;       ///< width of the index of a plane
};

/// Reads the sizes; returns zeros if there are too few bytes.
ModelSizes read_model_sizes(std::span<const std::uint8_t> display_model);

}  // namespace csgsim::division
