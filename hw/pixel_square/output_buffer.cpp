#include "hw/pixel_square/output_buffer.h"

#include "hw/base/quotient.h"

namespace csgsim::pixel_square {

void OutputBuffer::load(const array::PixelArray& pixels, isa::Field colour, const isa::Region& region) {
  const std::size_t count = std::size_t{region.width} * region.height;
  std::uint64_t next = std::uint64_t{quotient_up(header_bits, port_bits_)} * port_bits_;
  first_ = 0;
  size_ = next + std::uint64_t{count} * colour.width;
  bits_.assign(static_cast<std::size_t>(quotient_up(size_, 64U)), 0);
  put_bits(bits_, 0, header_bits, header_of(region));
  if (colour.width == 0) return;
  colours_.resize(count);
  pixels.read_field(colour, region.width, region.height, colours_);
  for (const std::uint32_t value : colours_) {
    put_bits(bits_, next, colour.width, value);
    next += colour.width;
  }
}

}  // namespace csgsim::pixel_square
