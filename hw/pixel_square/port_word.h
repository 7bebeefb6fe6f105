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

std::uint64_t header_of(const isa::Region& region);
isa::Region region_of(std::uint64_t header);

/// Writes the lowest `count` bits (0 to 64) of `value` to `into`, from bit `first` on. These bits must have been 0.
void put_bits(std::span<std::uint64_t> into, std::uint64_t first, unsigned count, std::uint64_t value);

/// Returns `count` bits from bit `first` on; bits beyond the end are 0.
PortBits slice_of(std::span<const std::uint64_t> bits, std::uint64_t first, std::uint32_t count);

// Required by sc_fifo; never called (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const PortWord& /*word*/) { return stream; }

}  // namespace csgsim::pixel_square
