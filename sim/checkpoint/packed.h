// Encoding of planes, pixels and bits in checkpoints.
// Used by decode.cpp and snapshot.cpp.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "hw/isa/bytes.h"

namespace csgsim::checkpoint {

// Functions that read throw isa::MalformedBytes. The format is described in sim/checkpoint/snapshot.h.

/// A number in `bytes` bytes, little-endian.
void put_fixed(isa::ByteWriter& out, std::uint64_t value, unsigned byte_count);
std::uint64_t read_fixed(isa::ByteReader& in, unsigned byte_count);

/// A plane of `words` words. An empty plane stands for zeros, and a plane of zeros is read as empty.
void put_plane(isa::ByteWriter& out, std::span<const std::uint64_t> plane, std::size_t word_count);
std::vector<std::uint64_t> read_plane(isa::ByteReader& in, std::size_t word_count);

/// The values of pixels in row order, as runs of equal values; `count` is their number.
void put_pixels(isa::ByteWriter& out, std::span<const std::uint32_t> pixels);
std::vector<std::uint32_t> read_pixels(isa::ByteReader& in, std::size_t count);

/// The number of bits, then 8 bits per byte. read_bits() rejects more than `max_count` bits.
void put_bits(isa::ByteWriter& out, const std::vector<bool>& bits);
std::vector<bool> read_bits(isa::ByteReader& in, std::uint64_t max_count);

}  // namespace csgsim::checkpoint
