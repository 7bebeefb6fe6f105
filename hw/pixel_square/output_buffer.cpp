#include "hw/pixel_square/output_buffer.h"

#include <algorithm>

namespace csgsim::pixel_square {

void OutputBuffer::load(const array::PixelArray& pixels, isa::Field colour, const isa::Region& region) {
  const std::size_t count = std::size_t{region.width} * region.height;
  region_ = region;
  first_ = 0;
  size_ = std::uint64_t{count} * colour.width;
  busy_ = true;
  if (size_ == 0) return;
  colours_.resize(count);
  pixels.read_field(colour, region.width, region.height, colours_);
  bits_.assign((size_ + 63) / 64, 0);
  for (std::size_t pixel = 0; pixel < count; ++pixel) {
    const std::uint64_t first = std::uint64_t{pixel} * colour.width;
    bits_[first / 64] |= std::uint64_t{colours_[pixel]} << (first % 64);
    if (first % 64 + colour.width > 64) bits_[first / 64 + 1] |= std::uint64_t{colours_[pixel]} >> (64 - first % 64);
  }
}

ColourWord OutputBuffer::word() const {
  ColourWord word{.region = region_,
                  .first = first_,
                  .count = static_cast<std::uint32_t>(std::min<std::uint64_t>(port_bits_, left())),
                  .last = left() <= port_bits_,
                  .bits = {}};
  word.bits.resize((word.count + 63U) / 64U);
  for (std::uint32_t i = 0; i < word.count; ++i) {
    if (bit(first_ + i)) word.bits[i / 64] |= std::uint64_t{1} << (i % 64);
  }
  return word;
}

void OutputBuffer::advance() {
  busy_ = left() > port_bits_;
  first_ += std::min<std::uint64_t>(port_bits_, left());
}

}  // namespace csgsim::pixel_square
