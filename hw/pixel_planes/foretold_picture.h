#pragma once

#include <cstdint>
#include <span>

#include "hw/array/plane.h"
#include "hw/isa/instruction.h"

namespace csgsim::pixel_planes {

/// The picture that another run has left in a field of the pixels, as the refresh port delivers it.
class ForetoldPicture {
 public:
  /// The colours, in row order, have to live as long.
  ForetoldPicture(array::PlaneShape shape, std::span<const std::uint32_t> colours) : shape_(shape), colours_(colours) {}

  void show(isa::Field field) { field_ = field; }

  /// Valid until the next is asked for.
  [[nodiscard]] std::span<const std::uint64_t> row(std::uint32_t address, std::uint32_t row) const;

 private:
  array::PlaneShape shape_;
  std::span<const std::uint32_t> colours_;
  isa::Field field_;
  mutable array::Words row_;
};

}  // namespace csgsim::pixel_planes
