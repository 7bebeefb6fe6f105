#include "hw/pixel_square/output_buffer.h"

#include <algorithm>

#include "hw/array/add_plane.h"
#include "hw/base/quotient.h"

namespace csgsim::pixel_square {

namespace {

/// Reads the colours of one row of pixels.
void read(const pixel_planes::RefreshPort& memory, isa::Field colour, std::uint32_t row,
          std::vector<std::uint32_t>& colours) {
  for (std::uint32_t bit = 0; bit < colour.width; ++bit)
    array::add_plane(memory.memory_row(colour.base + bit, row), bit, colours);
}

}  // namespace

bool OutputBuffer::needs_row() const {
  const std::uint64_t header = std::uint64_t{quotient_up(header_bits, port_bits_)} * port_bits_;
  return filled_ < size_ && std::max(first_, header) + port_bits_ > filled_;
}

void OutputBuffer::begin(const isa::Region& region, std::uint32_t colour_bits) {
  region_ = region;
  rows_ = 0;
  first_ = 0;
  filled_ = std::uint64_t{quotient_up(header_bits, port_bits_)} * port_bits_;
  size_ = filled_ + std::uint64_t{region.width} * region.height * colour_bits;
  bits_.assign(static_cast<std::size_t>(quotient_up(size_, 64U)), 0);
  put_bits(bits_, 0, header_bits, header_of(region));
}

void OutputBuffer::load_row(const pixel_planes::RefreshPort& memory, isa::Field colour) {
  colours_.assign(region_.width, 0);
  read(memory, colour, rows_++, colours_);
  for (const std::uint32_t value : colours_) {
    put_bits(bits_, filled_, colour.width, value);
    filled_ += colour.width;
  }
}

void OutputBuffer::load(const pixel_planes::RefreshPort& memory, isa::Field colour, const isa::Region& region) {
  begin(region, colour.width);
  for (std::uint32_t row = 0; row < region.height; ++row) load_row(memory, colour);
}

}  // namespace csgsim::pixel_square
