#pragma once

#include <cstddef>
#include <cstdint>

#include "sim/functional/bit_plane.h"

// Loops over blocks of enable words and the lanes below them, each compiled for several instruction sets and chosen at
// run time. A lane pointer points at the block's first pixel.

namespace csgsim::sim {

/// Where enabled: lanes := value.
void set_lanes(const WordBlock& enable, std::uint32_t* lanes, std::uint32_t value);

/// Where enabled: target := source.
void copy_lanes(const WordBlock& enable, std::uint32_t* target, const std::uint32_t* source);

/// Where enabled: target := the low bits of target + source.
void add_lanes(const WordBlock& enable, std::uint32_t* target, const std::uint32_t* source, std::uint32_t low_bits);

enum class Comparison : std::uint8_t { less, less_or_equal, equal };

/// enable := enable and left ? right.
void compare_lanes(const WordBlock& enable, Comparison comparison, const std::uint32_t* left,
                   const std::uint32_t* right);

/// bits := the bit of that number of each lane.
void gather_bit(const WordBlock& bits, const std::uint32_t* lanes, unsigned bit);

/// The bit of that number of each lane := bits; it is 0 before.
void scatter_bit(const WordBlock& bits, std::uint32_t* lanes, unsigned bit);

}  // namespace csgsim::sim
