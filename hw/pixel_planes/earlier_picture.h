// A known picture, delivered through the refresh port. Used by PixelPipeline.
#pragma once

#include <cstdint>
#include <span>

#include "hw/array/plane.h"
#include "hw/isa/instruction.h"

namespace csgsim::pixel_planes {

/// Delivers the picture that an earlier run left in a field of the pixels, in the format of the refresh port.
class EarlierPicture {
 public:
  /// `colours` is in row order and must outlive this object.
  EarlierPicture(array::PlaneShape shape, std::span<const std::uint32_t> colours) : shape_(shape), colours_(colours) {}

  /// Sets the field that holds the picture.
  void show(isa::Field field) { field_ = field; }

  /// A row of memory bit `address` of the displayed field, as RefreshPort::memory_row() returns it. Valid until the
  /// next call.
  [[nodiscard]] std::span<const std::uint64_t> row(std::uint32_t address, std::uint32_t row) const;

 private:
  array::PlaneShape shape_;
  std::span<const std::uint32_t> colours_;
  isa::Field field_;
  mutable array::Words row_;
};

}  // namespace csgsim::pixel_planes
