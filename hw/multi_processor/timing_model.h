#pragma once

#include <cstdint>

#include "hw/division/model_sizes.h"

namespace csgsim::multi_processor {

using division::ModelSizes;
using division::read_model_sizes;

// Words of the model's records on the bus or in a node's memory; each record begins at a new word.

/// Words of the records of the frame.
std::uint64_t frame_words(const ModelSizes& sizes, std::uint32_t word_bits);
/// Words of the records of a segment with the given numbers of surviving primitives and half-spaces.
std::uint64_t segment_words(const ModelSizes& sizes, std::uint64_t primitives, std::uint64_t halfspaces,
                            std::uint32_t word_bits);

/// Bits of a half-space's record.
std::uint64_t halfspace_bits(const ModelSizes& sizes);
/// Bits of the request for a half-space.
std::uint64_t request_bits(const ModelSizes& sizes);
/// Bits of a plane of the display model.
std::uint64_t plane_bits(const ModelSizes& sizes);

}  // namespace csgsim::multi_processor
