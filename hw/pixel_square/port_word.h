#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <ostream>
#include <span>

#include "hw/isa/program.h"
#include "hw/isa/wire.h"

/// Words of the FIFOs before the frame buffer, one word per clock. The FIFOs before the renderers hold link words.
namespace csgsim::pixel_square {

/// Bits of a port word; usually one element.
using PortBits = boost::container::small_vector<std::uint64_t, 1>;

inline std::span<const std::uint64_t> span_of(const PortBits& bits) { return {bits.data(), bits.size()}; }
inline std::span<std::uint64_t> span_of(PortBits& bits) { return {bits.data(), bits.size()}; }

/// A word to the frame buffer: `port.width` bits, 64 per element, the first on the lowest wire; bits beyond the width
/// are 0.
/// A square begins with its header: x, y, width and height of its region, wire_region_bits each, least significant bit
/// first. Its colours start with a new word, in row order, least significant bit of each colour first. A header without
/// colours, sent by the sender, requests the clearing of the square.
struct PortWord {
  PortBits bits;
};

inline constexpr unsigned header_bits = 4 * isa::wire_region_bits;
static_assert(header_bits == 64);

/// Header of the square with that region.
std::uint64_t header_of(const isa::Region& region);
/// Region of the square with that header.
isa::Region region_of(std::uint64_t header);

/// Writes the lowest `bit_count` bits (0 to 64) of `value` to `words`, from bit `first_bit` on; these bits of `words`
/// must be 0.
void put_bits(std::span<std::uint64_t> words, std::uint64_t first_bit, unsigned bit_count, std::uint64_t value);

/// Returns `bit_count` bits of `bits` from bit `first_bit` on; bits beyond the end are 0.
PortBits slice_of(std::span<const std::uint64_t> bits, std::uint64_t first_bit, std::uint32_t bit_count);

// Required by sc_fifo; never called (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const PortWord& /*word*/) { return stream; }

}  // namespace csgsim::pixel_square
