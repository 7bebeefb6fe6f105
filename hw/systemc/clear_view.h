// PixelView of cleared pixels.
// Used by hw/pixel_square and hw/multi_processor.
#pragma once

#include <algorithm>

#include "hw/systemc/run_listener.h"

namespace csgsim::systemc {

/// Pixels that were cleared and not drawn: memory and enable are 0.
class ClearView final : public PixelView {
 public:
  void read_field(isa::Field /*field*/, std::uint32_t /*width*/, std::uint32_t /*height*/,
                  std::span<std::uint32_t> values) const override {
    std::fill(values.begin(), values.end(), 0U);
  }
  void read_enable(std::uint32_t /*width*/, std::uint32_t /*height*/, std::span<std::uint64_t> words) const override {
    std::fill(words.begin(), words.end(), 0U);
  }
  [[nodiscard]] std::unique_ptr<const PixelView> copy() const override { return std::make_unique<ClearView>(); }
};

}  // namespace csgsim::systemc
