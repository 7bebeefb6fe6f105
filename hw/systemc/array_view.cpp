#include "hw/systemc/array_view.h"

#include <algorithm>

namespace csgsim::systemc {

void ArrayView::read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                           std::span<std::uint32_t> values) const {
  pixels_->read_field(field, width, height, values);
}

void ArrayView::read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const {
  const std::size_t array_row = pixels_->shape().row_words();
  const std::size_t region_row = array::PlaneShape{width, height}.row_words();
  const std::span<const std::uint64_t> enable = pixels_->enable();
  if (region_row == array_row) {
    std::copy_n(enable.begin(), region_row * height, words.begin());
    return;
  }
  for (std::size_t y = 0; y < height; ++y) {
    std::copy_n(&enable[y * array_row], region_row, &words[y * region_row]);
  }
}

std::unique_ptr<const PixelView> ArrayView::copy() const {
  return std::make_unique<ArrayView>(std::make_shared<const array::PixelArray>(*pixels_));
}

}  // namespace csgsim::systemc
