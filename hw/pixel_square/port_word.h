#pragma once

#include <boost/container/small_vector.hpp>
#include <cstdint>
#include <ostream>
#include <span>

#include "hw/isa/program.h"
#include "hw/isa/wire.h"

/// What travels through the FIFOs before the frame buffer, one word a clock. Those before the renderers hold words of
/// the link.
namespace csgsim::pixel_square {

/// As a rule one element.
using PortBits = boost::container::small_vector<std::uint64_t, 1>;

inline std::span<const std::uint64_t> span_of(const PortBits& bits) { return {bits.data(), bits.size()}; }
inline std::span<std::uint64_t> span_of(PortBits& bits) { return {bits.data(), bits.size()}; }

/// To the frame buffer: `port.width` bits, 64 an element, the first on the lowest wire; bits beyond the width are 0.
///
/// A square begins with its header, x, y, width and height of its region with wire_region_bits each, the least
/// significant bit first. Its colours follow from a new word on, in row order, the least significant bit of each first.
/// From the sender, a header alone asks for the square to be cleared.
struct PortWord {
  PortBits bits;
};

inline constexpr unsigned header_bits = 4 * isa::wire_region_bits;
static_assert(header_bits == 64);

std::uint64_t header_of(const isa::Region& region);
isa::Region region_of(std::uint64_t header);

/// Puts `count` bits (0 to 64) where only zeros are.
void put_bits(std::span<std::uint64_t> into, std::uint64_t first, unsigned count, std::uint64_t value);

/// `count` bits from `first` on, those beyond the end 0.
PortBits slice_of(std::span<const std::uint64_t> bits, std::uint64_t first, std::uint32_t count);

// Which nobody calls (hw/systemc/wire.h).
inline std::ostream& operator<<(std::ostream& stream, const PortWord& /*word*/) { return stream; }

}  // namespace csgsim::pixel_square
