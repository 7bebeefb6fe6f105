#include "hw/pixel_square/port_word.h"

#include <algorithm>

namespace csgsim::pixel_square {

std::uint64_t header_of(const isa::Region& region) {
  std::uint64_t header = 0;
  unsigned first = 0;
  for (const std::uint32_t number : {region.x, region.y, region.width, region.height}) {
    header |= std::uint64_t{number} << first;
    first += isa::wire_region_bits;
  }
  return header;
}

isa::Region region_of(std::uint64_t header) {
  const auto number = [header](unsigned place) {
    return static_cast<std::uint32_t>(header >> (place * isa::wire_region_bits) & ((1U << isa::wire_region_bits) - 1U));
  };
  return {number(0), number(1), number(2), number(3)};
}

void put_bits(std::span<std::uint64_t> into, std::uint64_t first, unsigned count, std::uint64_t value) {
  if (count == 0) return;
  const auto place = static_cast<unsigned>(first % 64);
  into[first / 64] |= value << place;
  if (place + count > 64) into[first / 64 + 1] |= value >> (64 - place);
}

PortBits slice_of(std::span<const std::uint64_t> bits, std::uint64_t first, std::uint32_t count) {
  PortBits slice((count + 63U) / 64U);
  const auto shift = static_cast<unsigned>(first % 64);
  const auto at = [&](std::uint64_t index) { return index < bits.size() ? bits[index] : 0; };
  for (std::size_t i = 0; i < slice.size(); ++i) {
    const std::uint64_t from = first / 64 + i;
    slice[i] = at(from) >> shift;
    if (shift > 0) slice[i] |= at(from + 1) << (64 - shift);
  }
  if (count % 64 > 0) slice.back() &= (std::uint64_t{1} << count % 64) - 1;
  return slice;
}

}  // namespace csgsim::pixel_square
