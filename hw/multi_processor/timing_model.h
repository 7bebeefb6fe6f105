#pragma once

#include <cstdint>
#include <span>

namespace csgsim::multi_processor {

/// Numbers and widths in bits at the beginning of a display model (docs/division.md), read without its divider.
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
};

/// All 0 where there are too few bytes.
ModelSizes sizes_of(std::span<const std::uint8_t> display_model);

/// What of the model is on the bus, or in a node's memory, in words of so many bits: each record begins at a new one.
std::uint64_t frame_words(const ModelSizes& sizes, std::uint32_t word_bits);
std::uint64_t segment_words(const ModelSizes& sizes, std::uint64_t primitives, std::uint64_t halfspaces,
                            std::uint32_t word_bits);

}  // namespace csgsim::multi_processor
