#pragma once

#include <algorithm>

#include "hw/array/pixel_array.h"
#include "sim/engine/engine.h"

namespace csgsim::sim {

/// The corner of the array that a segment's region occupies.
class ArrayState final : public PixelState {
 public:
  ArrayState(const array::PixelArray& pixels, isa::Region region) : pixels_(pixels), region_(region) {}

  [[nodiscard]] isa::Region region() const override { return region_; }

  void read_field(isa::Field field, std::span<std::uint32_t> values) const override {
    pixels_.read_field(field, region_.width, region_.height, values);
  }

  void read_enable(std::span<std::uint64_t> words) const override {
    const std::size_t array_row = pixels_.shape().row_words();
    const std::size_t region_row = array::PlaneShape{region_.width, region_.height}.row_words();
    const std::span<const std::uint64_t> enable = pixels_.enable();
    for (std::size_t y = 0; y < region_.height; ++y) {
      std::copy_n(&enable[y * array_row], region_row, &words[y * region_row]);
    }
  }

 private:
  const array::PixelArray& pixels_;
  isa::Region region_;
};

}  // namespace csgsim::sim
