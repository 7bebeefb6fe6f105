// PixelView of a pixel array.
// Used by hw/pixel_planes and hw/pixel_square.
#pragma once

#include <memory>
#include <utility>

#include "hw/array/pixel_array.h"
#include "hw/systemc/run_listener.h"

namespace csgsim::systemc {

/// The pixels of a region in the top left corner of an array of pixel processors.
class ArrayView final : public PixelView {
 public:
  /// The pixels must outlive the view.
  explicit ArrayView(const array::PixelArray& pixels) : pixels_(std::shared_ptr<void>(), &pixels) {}
  explicit ArrayView(std::shared_ptr<const array::PixelArray> pixels) : pixels_(std::move(pixels)) {}

  void read_field(isa::Field field, std::uint32_t width, std::uint32_t height,
                  std::span<std::uint32_t> values) const override;
  void read_enable(std::uint32_t width, std::uint32_t height, std::span<std::uint64_t> words) const override;
  [[nodiscard]] std::unique_ptr<const PixelView> copy() const override;

 private:
  std::shared_ptr<const array::PixelArray> pixels_;
};

}  // namespace csgsim::systemc
