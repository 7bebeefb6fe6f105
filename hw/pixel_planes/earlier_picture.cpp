#include "hw/pixel_planes/earlier_picture.h"

namespace csgsim::pixel_planes {

std::span<const std::uint64_t> EarlierPicture::row(std::uint32_t address, std::uint32_t row) const {
  row_.assign(shape_.row_words(), 0);
  const std::uint32_t bit = address - field_.base;
  for (std::uint32_t x = 0; x < shape_.width; ++x) {
    const std::uint64_t colour = colours_[std::size_t{row} * shape_.width + x];
    row_[x / array::word_bits] |= (colour >> bit & 1U) << (x % array::word_bits);
  }
  return row_;
}

}  // namespace csgsim::pixel_planes
