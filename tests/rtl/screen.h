#pragma once

#include <cstdint>
#include <vector>

#include "tests/rtl/rtl_machine.h"

namespace csgsim::rtl {

/// Collects the pixels shown by the Verilog into pictures.
class Screen {
 public:
  /// A screen with `width` columns, whose pixels have `colour_bits` wires.
  Screen(std::uint32_t width, std::uint32_t pixels, std::uint32_t colour_bits)
      : width_(width), pixels_(pixels), colour_bits_(colour_bits) {}

  /// Records the pixels shown in a clock.
  void show(const Outputs& outputs);

  /// The colours shown since the most recent start of a picture, in row order.
  [[nodiscard]] const std::vector<std::uint32_t>& picture() const { return picture_; }

 private:
  std::uint32_t width_;
  std::uint32_t pixels_;  ///< pixels per clock
  std::uint32_t colour_bits_;
  std::uint32_t column_ = 0;
  std::vector<std::uint32_t> picture_;
};

}  // namespace csgsim::rtl
