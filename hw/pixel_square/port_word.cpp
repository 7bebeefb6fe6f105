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

void put_bits(std::span<std::uint64_t> words, std::uint64_t first_bit, unsigned bit_count, std::uint64_t value) {
  if (bit_count == 0) return;
  const auto place = static_cast<unsigned>(first_bit % 64);
  words[first_bit / 64] |= value << place;
  if (place + bit_count > 64) words[first_bit / 64 + 1] |= value >> (64 - place);
}

PortBits slice_of(std::span<const std::uint64_t> bits, std::uint64_t first_bit, std::uint32_t bit_count) {
  PortBits slice((bit_count + 63U) / 64U);
  const auto shift = static_cast<unsigned>(first_bit % 64);
  const auto at = [&](std::uint64_t index) { return index < bits.size() ? bits[index] : 0; };
  for (std::size_t i = 0; i < slice.size(); ++i) {
    const std::uint64_t from = first_bit / 64 + i;
    slice[i] = at(from) >> shift;
    if (shift > 0) slice[i] |= at(from + 1) << (64 - shift);
  }
  if (bit_count % 64 > 0) slice.back() &= (std::uint64_t{1} << bit_count % 64) - 1;
  return slice;
}

}  // namespace csgsim::pixel_square
