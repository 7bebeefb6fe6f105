#include "hw/pixel_square/output_buffer.h"

#include <algorithm>
#include <span>

#include "hw/array/plane.h"
#include "hw/base/quotient.h"

namespace csgsim::pixel_square {

namespace {

/// The colours of the region's pixels, in row order.
void read(const pixel_planes::RefreshPort& memory, isa::Field colour, const isa::Region& region,
          std::vector<std::uint32_t>& colours) {
  colours.assign(std::size_t{region.width} * region.height, 0);
  for (std::uint32_t bit = 0; bit < colour.width; ++bit) {
    auto pixel = colours.begin();
    for (std::uint32_t y = 0; y < region.height; ++y) {
      const std::span<const std::uint64_t> row = memory.memory_row(colour.base + bit, y);
      for (std::uint32_t x = 0; x < region.width; ++x) {
        *pixel++ |= static_cast<std::uint32_t>(row[x / array::word_bits] >> (x % array::word_bits) & 1U) << bit;
      }
    }
  }
}

}  // namespace

void OutputBuffer::load(const pixel_planes::RefreshPort& memory, isa::Field colour, const isa::Region& region) {
  std::uint64_t next = std::uint64_t{quotient_up(header_bits, port_bits_)} * port_bits_;
  first_ = 0;
  size_ = next + std::uint64_t{region.width} * region.height * colour.width;
  bits_.assign(static_cast<std::size_t>(quotient_up(size_, 64U)), 0);
  put_bits(bits_, 0, header_bits, header_of(region));
  read(memory, colour, region, colours_);
  for (const std::uint32_t value : colours_) {
    put_bits(bits_, next, colour.width, value);
    next += colour.width;
  }
}

}  // namespace csgsim::pixel_square
